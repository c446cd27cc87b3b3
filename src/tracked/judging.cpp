// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/judging.h"

#include <algorithm>
#include <utility>

#include "parallel.h"
#include "tracked/densify.h"
#include "tracked/steps.h"

namespace isomatch::tracked {
namespace {

/// Of landmarks that share a node the first remains.
void drop_repeated_nodes(Correspondence& landmarks) {
  Correspondence kept;
  for (const Match& match : landmarks) {
    const bool repeated = std::ranges::any_of(kept, [&](const Match& other) {
      return other.source == match.source || other.target == match.target;
    });
    if (!repeated) kept.push_back(match);
  }
  landmarks = std::move(kept);
}

HypothesisOptions with_landmarks(const Model& source, const Model& target,
                                 const TrackerOptions& options) {
  HypothesisOptions result = options.hypotheses;
  for (const Match& match : options.landmarks)
    result.landmarks.push_back({nearest_node(source, match.source, source.proxy.num_measured()),
                                nearest_node(target, match.target, target.proxy.num_measured())});
  drop_repeated_nodes(result.landmarks);
  const auto most = static_cast<std::size_t>(result.coarse.source_landmarks / 2);
  result.landmarks.resize(std::min(result.landmarks.size(), most));
  result.growth.fixed = static_cast<int>(result.landmarks.size());
  return result;
}

/// Energy of a coarse, stiff registration that starts from a hypothesis.
double energy(const Model& source, const Model& target, const Hypothesis& hypothesis,
              const elastic::Projection& surface, const TrackerOptions& options) {
  elastic::PointCloud cloud = source.coarse.graph.cloud;
  const std::vector<int> vertices = node_vertices(
      target.proxy, densify(source.proxy, target.proxy, hypothesis, source.coarse.size()));
  set_places(cloud, target.proxy, vertices);
  elastic::Deformation deformation(cloud.positions, source.coarse.graph.neighbours);
  return register_onto(cloud, deformation, surface, selected(target.proxy.mesh.vertices, vertices),
                       options.judging)
      .energy;
}

}  // namespace

std::vector<Judged> judged_hypotheses(const Model& source, const Model& target,
                                      const TrackerOptions& options, const Context& context) {
  // Of the time, how much finding takes.
  constexpr double kFound = 0.7;
  std::vector<Hypothesis> hypotheses =
      find_hypotheses(source.proxy, target.proxy, with_landmarks(source, target, options),
                      part_of(context, 0, kFound));
  const elastic::Projection surface = projection_onto(target.proxy, options.early_projection);
  Steps steps(context, "hypotheses", kFound, 1, static_cast<int>(hypotheses.size()));
  std::vector<Judged> judged(hypotheses.size());
  parallel_for(std::ssize(hypotheses), context, [&](std::ptrdiff_t k) {
    const double e = energy(source, target, hypotheses[k], surface, options);
    judged[k] = {std::move(hypotheses[k]), e, &source};
    steps.take();
  });
  if (options.elastic_judging) sort_by_cost(judged);
  return judged;
}

void sort_by_cost(std::vector<Judged>& judged) {
  std::ranges::stable_sort(judged, {}, &Judged::cost);
}

}  // namespace isomatch::tracked
