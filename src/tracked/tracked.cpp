// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/tracked.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "isomatch/error.h"
#include "parallel.h"
#include "tracked/dense_map.h"
#include "tracked/steps.h"
#include "tracked/tracker.h"

namespace isomatch {
namespace {

using namespace tracked;

TrackerOptions tracker_options(const TrackedOptions& options) {
  TrackerOptions result;
  result.landmarks = options.landmarks;
  result.elastic_judging = options.elastic_judging;
  result.hypotheses.growth.orientation = options.orientation;
  result.different_maps = options.alternatives + 1;
  if (!options.elastic_judging) result.entrants = result.finalists = 1;
  if (!options.refinement) result.rounds = 0;
  return result;
}

void check_landmarks(const Correspondence& landmarks, const Surface& source,
                     const Surface& target) {
  std::vector<bool> used(source.num_vertices(), false);
  for (const auto& [s, t] : landmarks) {
    if (s < 0 || s >= source.num_vertices() || t < 0 || t >= target.num_vertices())
      throw InvalidInput("a landmark is no vertex of the surfaces");
    if (used[s]) throw InvalidInput("a source vertex has two landmarks");
    used[s] = true;
  }
}

/// Where of the whole stages begin, as measured on shapes of 5,000 to 42,000 vertices.
constexpr double kHypothesesBegin = 0.28, kRefinementBegin = 0.6, kDenseMapBegin = 0.97;

/// The target, the source, and the source's mirror image if that may match as well.
std::vector<Model> make_models(const Surface& source, const Surface& target, bool with_mirror,
                               const TrackerOptions& options, const Context& context) {
  struct Request {
    const Surface* surface;
    bool mirrored;
  };
  std::vector<Request> requests{{&target, false}, {&source, false}};
  if (with_mirror) requests.push_back({&source, true});
  Steps steps(context, "models", 0, 1, kModelSteps * static_cast<int>(requests.size()));
  const Context alone{.threads = 1,
                      .progress = [&](double, std::string_view) { steps.take(); },
                      .stop = context.stop};
  std::vector<std::optional<Model>> made(requests.size());
  parallel_for(std::ssize(requests), context, [&](std::ptrdiff_t k) {
    made[k].emplace(make_model(*requests[k].surface, requests[k].mirrored, options, alone));
  });
  std::vector<Model> models;
  for (auto& model : made) models.push_back(std::move(*model));
  return models;
}

/// Hypotheses of all sources, least cost first; the first of the models is the target.
Candidates all_judged(const std::vector<Model>& models, const TrackerOptions& options,
                      const Context& context) {
  const double share = 1.0 / static_cast<double>(models.size() - 1);
  Candidates all;
  for (std::size_t k = 1; k < models.size(); ++k) {
    const double end = static_cast<double>(k) * share;
    Candidates more =
        judged_hypotheses(models[k], models[0], options, part_of(context, end - share, end));
    std::ranges::move(more.possible, std::back_inserter(all.possible));
    std::ranges::move(more.contradicting, std::back_inserter(all.contradicting));
  }
  if (models.size() > 2) {
    sort_by_cost(all.possible);
    sort_by_cost(all.contradicting);
  }
  return all;
}

std::vector<TrackedMap> dense_maps(const std::vector<Track>& tracks, const Model& target,
                                   const TrackerOptions& options, const Context& context) {
  Steps steps(context, "dense map", 0, 1, static_cast<int>(tracks.size()));
  std::vector<TrackedMap> maps;
  for (const Track& track : tracks) {
    maps.push_back(dense_map(track, target, options, context));
    steps.take();
  }
  return maps;
}

}  // namespace

void TrackedOptions::validate() const {
  if (alternatives < 0) throw InvalidInput("alternatives must not be negative");
}

TrackedResult match_tracked(const Surface& source, const Surface& target,
                            const TrackedOptions& options, const Context& context) {
  options.validate();
  check_landmarks(options.landmarks, source, target);
  const TrackerOptions tracking = tracker_options(options);
  TrackedResult result;
  const auto timed = [&](std::string_view stage, double begin, double end, const auto& work) {
    context.report(begin, stage);
    const StageTimer timer(result.times, stage);
    return work(part_of(context, begin, end));
  };
  const std::vector<Model> models = timed("models", 0, kHypothesesBegin, [&](const Context& part) {
    return make_models(source, target, options.allow_reflection, tracking, part);
  });
  result.oriented = models[0].proxy.oriented && models[1].proxy.oriented;
  const Candidates candidates =
      timed("hypotheses", kHypothesesBegin, kRefinementBegin,
            [&](const Context& part) { return all_judged(models, tracking, part); });
  if (candidates.possible.empty())
    throw InvalidInput(
        candidates.contradicting.empty()
            ? "the shapes have too little in common: there is no hypothesis to follow"
            : "there is no map that satisfies the landmarks");
  for (const Judged& j : candidates.possible)
    result.hypotheses.push_back({j.hypothesis.distortion, j.hypothesis.orientation, j.energy});
  const Finals finals =
      timed("refinement", kRefinementBegin, kDenseMapBegin, [&](const Context& part) {
        return run_finals(models[0], candidates.possible, tracking, part);
      });
  result.contradicted_landmarks = contradicted_landmarks(models[0], candidates.contradicting,
                                                         finals.middle_cost, tracking, context);
  result.ambiguity = finals.ambiguity;
  result.maps = timed("dense map", kDenseMapBegin, 1, [&](const Context& part) {
    return dense_maps(finals.tracks, models[0], tracking, part);
  });
  return result;
}

Correspondence matches(const Surface& source, const Surface& target, const TrackedMap& map) {
  const VertexMap forward = nearest_vertices(target.mesh, map.source_to_target);
  const VertexMap backward = nearest_vertices(source.mesh, map.target_to_source);
  Correspondence matches = to_correspondence(forward);
  std::vector<bool> hit(backward.size(), false);
  for (const Match& match : matches) hit[match.target] = true;
  for (std::size_t t = 0; t < backward.size(); ++t)
    if (!hit[t] && backward[t] != kUnmatched) matches.push_back({backward[t], static_cast<int>(t)});
  std::ranges::sort(matches);
  return matches;
}

}  // namespace isomatch
