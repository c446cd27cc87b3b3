// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/tracked.h"

#include <algorithm>

#include "isomatch/error.h"
#include "tracked/tracker.h"

namespace isomatch {
namespace {

using namespace tracked;

SurfaceMap project(const std::vector<Point>& positions, const std::vector<Point>& normals,
                   const std::vector<elastic::Features>& features,
                   const elastic::Projection& surface, const Context& context) {
  SurfaceMap map(positions.size());
#pragma omp parallel for schedule(static) num_threads(context.threads)
  for (std::size_t v = 0; v < map.size(); ++v) {
    const elastic::Foot foot = surface(positions[v], normals[v], features[v]);
    map[v] = {foot.face, foot.weights};
  }
  return map;
}

TrackedMap dense_map(const Model& source, const Model& target, const Track& track,
                     const Hypothesis& hypothesis, const TrackerOptions& options,
                     const Context& context) {
  const DeformedSurface deformed =
      transfer(source.shape, source.surface, source.proxy, track.deformation);
  const elastic::Projection onto_target(target.surface.mesh, target.surface.faces,
                                        target.surface.normals, target.surface.features,
                                        options.projection);
  const Mesh deformed_mesh{deformed.positions, source.surface.mesh.faces};
  const elastic::Projection onto_source(deformed_mesh, source.surface.faces, deformed.normals,
                                        source.surface.features, options.projection);
  TrackedMap map;
  map.source_to_target =
      project(deformed.positions, deformed.normals, source.surface.features, onto_target, context);
  map.target_to_source = project(target.surface.mesh.vertices, target.surface.normals,
                                 target.surface.features, onto_source, context);
  for (const Point& p : deformed.positions)
    map.registered.push_back(p * target.surface.scale + target.surface.centre);
  map.energy = track.energy;
  map.distance = track.registration.distance;
  map.deviation = track.registration.deviation;
  map.distortion = hypothesis.distortion;
  map.orientation = hypothesis.orientation;
  return map;
}

}  // namespace

void TrackedOptions::validate() const {
  if (alternatives < 0) throw InvalidInput("alternatives must not be negative");
}

TrackedResult match_tracked(const Shape& source, const Shape& target, const TrackedOptions& options,
                            const Context& context) {
  options.validate();
  TrackerOptions tracker_options;
  tracker_options.finalists = std::max(tracker_options.finalists, options.alternatives + 1);
  TrackedResult result;
  const auto timed = [&](std::string_view stage, const auto& work) {
    context.check_stop();
    const StageTimer timer(result.times, stage);
    return work();
  };
  context.report(0, "preparing");
  const auto [from, onto] =
      timed("proxies", [&] { return make_models(source, target, tracker_options, context); });
  result.oriented = from.proxy.oriented && onto.proxy.oriented;
  context.report(0.4, "hypotheses");
  std::vector<Hypothesis> hypotheses = timed("hypotheses", [&] {
    return find_hypotheses(from.proxy, onto.proxy, tracker_options.hypotheses, context);
  });
  if (hypotheses.empty())
    throw InvalidInput("the shapes have too little in common: no hypothesis was found");
  const std::vector<Judged> judged = timed("judging", [&] {
    return judge(from, onto, std::move(hypotheses), tracker_options, context);
  });
  for (const Judged& j : judged)
    result.hypotheses.push_back({j.hypothesis.distortion, j.hypothesis.orientation, j.energy});
  context.report(0.6, "refinement");
  const std::vector<Finalist> finalists =
      timed("refinement", [&] { return run_finals(from, onto, judged, tracker_options, context); });
  result.confidence = finalists.size() < 2 ? 1
                                           : 1 - finalists[0].track.registration.energy /
                                                     finalists[1].track.registration.energy;
  timed("dense map", [&] {
    for (std::size_t k = 0; k < finalists.size() && std::cmp_less_equal(k, options.alternatives);
         ++k)
      result.maps.push_back(dense_map(from, onto, finalists[k].track, finalists[k].hypothesis,
                                      tracker_options, context));
  });
  return result;
}

Correspondence matches(const Shape& source, const Shape& target, const TrackedMap& map) {
  const VertexMap forward = nearest_vertices(target.surface.mesh, map.source_to_target);
  const VertexMap backward = nearest_vertices(source.surface.mesh, map.target_to_source);
  Correspondence matches = to_correspondence(forward);
  std::vector<bool> hit(backward.size(), false);
  for (const Match& match : matches) hit[match.target] = true;
  for (std::size_t t = 0; t < backward.size(); ++t)
    if (!hit[t] && backward[t] != kUnmatched) matches.push_back({backward[t], static_cast<int>(t)});
  std::ranges::sort(matches);
  return matches;
}

}  // namespace isomatch
