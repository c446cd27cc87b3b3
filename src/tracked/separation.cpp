// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/separation.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "steps.h"
#include "tracked/tracks/deformed_surface.h"

namespace isomatch::tracked {
namespace {

double least_cost(const Candidates& candidates) {
  return candidates.possible.empty() ? std::numeric_limits<double>::infinity()
                                     : candidates.possible.front().cost();
}

/// Vertices of the surface on both sides of edges between cells of nodes that are torn apart where
/// they move to `places`.
Cut torn_vertices(const Pyramid& pyramid, const std::vector<Point>& rest_places,
                  const std::vector<Point>& places, const ContactOptions& options) {
  const auto torn = [&](int i, int j) {
    const double rest = (rest_places[i] - rest_places[j]).norm();
    const double now = (places[i] - places[j]).norm();
    return now > options.torn * rest && now - rest > options.gap;
  };
  const std::vector<int> cell = detail_cells(pyramid, static_cast<int>(places.size()));
  Cut cut;
  for (const Face& face : pyramid.detail.mesh.faces)
    for (int k = 0; k < 3; ++k)
      if (torn(cell[face[k]], cell[face[(k + 1) % 3]]))
        for (const int v : {face[k], face[(k + 1) % 3]})
          cut.push_back(pyramid.detail.surface_vertex[v]);
  std::ranges::sort(cut);
  const auto repeated = std::ranges::unique(cut);
  cut.erase(repeated.begin(), repeated.end());
  return cut;
}

}  // namespace

Candidates all_judged(const Pyramids& pyramids, const Options& options, const Context& context) {
  const double share = 1.0 / static_cast<double>(pyramids.size() - 1);
  Candidates all;
  for (std::size_t k = 1; k < pyramids.size(); ++k) {
    const double end = static_cast<double>(k) * share;
    Candidates more =
        judged_hypotheses(*pyramids[k], *pyramids[0], options, part_of(context, end - share, end));
    std::ranges::move(more.possible, std::back_inserter(all.possible));
    std::ranges::move(more.contradicting, std::back_inserter(all.contradicting));
  }
  if (pyramids.size() > 2) {
    sort_by_cost(all.possible);
    sort_by_cost(all.contradicting);
  }
  return all;
}

Separation::Separation(const Pyramids& pyramids, Make make, const Options& options,
                       const Context& context)
    : make_(std::move(make)), options_(options) {
  for (const auto& pyramid : pyramids)
    cuts_.push_back(possible_cuts(pyramid->detail, options.contacts, context));
}

std::shared_ptr<const Pyramid> Separation::with_cut(const Pyramids& pyramids, std::size_t k,
                                                    Cut cut) const {
  View view = pyramids[k]->view;
  view.cut = std::move(cut);
  return make_(k, view);
}

bool Separation::is_possible() const {
  return std::ranges::any_of(cuts_, [](const auto& cuts) { return !cuts.empty(); });
}

void Separation::open_handles(Pyramids& pyramids, Candidates& candidates,
                              const Context& context) const {
  if (!is_possible()) return;
  // First all shapes are cut, then every other choice for one shape is tried.
  std::size_t tried = 0, most = 1;
  for (const std::vector<Cut>& cuts : cuts_) most += cuts.size();
  const double share = 1.0 / static_cast<double>(most);
  double least = least_cost(candidates);
  const auto replace_if_better = [&](Pyramids others) {
    const double begin = share * static_cast<double>(tried++);
    Candidates found = all_judged(others, options_, part_of(context, begin, begin + share));
    const double cost = least_cost(found);
    if (cost >= least) return;
    least = cost;
    pyramids = std::move(others);
    candidates = std::move(found);
  };
  Pyramids apart = pyramids;
  for (std::size_t k = 0; k < pyramids.size(); ++k)
    if (!cuts_[k].empty()) apart[k] = with_cut(pyramids, k, cuts_[k].front());
  replace_if_better(std::move(apart));
  for (std::size_t k = 0; k < pyramids.size(); ++k) {
    std::vector<Cut> others = cuts_[k];
    if (!others.empty()) others.emplace_back();
    std::erase(others, pyramids[k]->view.cut);
    for (Cut& cut : others) {
      Pyramids changed = pyramids;
      changed[k] = with_cut(pyramids, k, std::move(cut));
      replace_if_better(std::move(changed));
    }
  }
}

Pyramids Separation::cut_where_torn(const Pyramids& pyramids, const Track& track,
                                    const std::vector<int>& nearest) const {
  Pyramids result = pyramids;
  const std::vector<Point>& rest = track.source->graph.cloud.positions;
  for (std::size_t k = 0; k < pyramids.size(); ++k) {
    if (cuts_[k].empty()) continue;
    const Pyramid& pyramid = *pyramids[k];
    Cut torn;
    if (k == 0)
      torn = torn_vertices(pyramid, track.target->graph.cloud.positions, selected(rest, nearest),
                           options_.contacts);
    else if (&pyramid == track.judged.source)
      torn = torn_vertices(pyramid, rest, track.deformation.positions(), options_.contacts);
    if (!torn.empty()) result[k] = with_cut(pyramids, k, united(pyramid.view.cut, torn));
  }
  return result;
}

}  // namespace isomatch::tracked
