// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/tracked.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "isomatch/error.h"
#include "tracked/tracker.h"
#include "tracked/transfer.h"

namespace isomatch {
namespace {

using namespace tracked;

/// Positions and what else tells points apart, ready to be projected.
struct Cloud {
  const std::vector<Point>& positions;
  const std::vector<Point>& normals;
  const std::vector<elastic::Features>& features;
};

/// The closest points of `surface`, with the faces as they are in the shape.
SurfaceMap project(const Cloud& cloud, const elastic::Projection& projection,
                   const UnitSurface& surface, const Context& context) {
  SurfaceMap map(cloud.positions.size());
#pragma omp parallel for schedule(static) num_threads(context.threads)
  for (std::size_t v = 0; v < map.size(); ++v) {
    const elastic::Foot foot = projection(cloud.positions[v], cloud.normals[v], cloud.features[v]);
    map[v] = {foot.face, foot.weights};
    if (surface.turned[foot.face]) std::swap(map[v].weights[1], map[v].weights[2]);
  }
  return map;
}

/// Moves what is near a landmark along with it, so that the landmark arrives.
void bend_to_landmarks(const Model& source, const Model& target, const Correspondence& landmarks,
                       DeformedSurface& deformed) {
  constexpr double kReach = 0.05;
  std::vector<Point> moves;
  for (const Match& match : landmarks)
    moves.push_back(target.surface.mesh.vertices[match.target] - deformed.positions[match.source]);
  const std::vector<Point>& rest = source.surface.mesh.vertices;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
      const double distance = (rest[v] - rest[landmarks[k].source]).norm() / kReach;
      deformed.positions[v] += std::exp(-distance * distance) * moves[k];
    }
  }
}

/// The point of `mesh` at a vertex.
SurfacePoint point_at(const Mesh& mesh, const IndexLists& vertex_faces, int vertex) {
  SurfacePoint point{vertex_faces[vertex].front(), {}};
  point
      .weights[std::ranges::find(mesh.faces[point.face], vertex) - mesh.faces[point.face].begin()] =
      1;
  return point;
}

TrackedMap dense_map(const Track& track, const Model& target, const TrackerOptions& options,
                     const Context& context) {
  const Model& source = *track.judged.source;
  DeformedSurface deformed =
      transfer(source.shape, source.surface, source.proxy, track.deformation, track.cloud.features);
  bend_to_landmarks(source, target, options.landmarks, deformed);
  const auto& goal = target.surface;
  const elastic::Projection onto_target(goal.mesh, goal.faces, goal.normals, goal.features,
                                        options.late_projection);
  const Mesh deformed_mesh{deformed.positions, source.surface.mesh.faces};
  const elastic::Projection onto_source(deformed_mesh, source.surface.faces, deformed.normals,
                                        deformed.features, options.late_projection);
  TrackedMap map;
  map.source_to_target = project({deformed.positions, deformed.normals, deformed.features},
                                 onto_target, goal, context);
  map.target_to_source = project({goal.mesh.vertices, goal.normals, goal.features}, onto_source,
                                 source.surface, context);
  for (const Match& match : options.landmarks)
    map.source_to_target[match.source] =
        point_at(target.shape.surface.mesh, goal.faces, match.target);
  for (const Point& p : deformed.positions) map.registered.push_back(p * goal.scale + goal.centre);
  map.energy = track.registration.energy;
  map.distance = track.registration.distance;
  map.deviation = track.registration.deviation;
  map.distortion = track.judged.hypothesis.distortion;
  map.orientation = track.judged.hypothesis.orientation;
  map.mirrored = source.mirrored;
  return map;
}

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

void check_landmarks(const Correspondence& landmarks, const Shape& source, const Shape& target) {
  std::vector<bool> used(source.num_vertices(), false);
  for (const auto& [s, t] : landmarks) {
    if (s < 0 || s >= source.num_vertices() || t < 0 || t >= target.num_vertices())
      throw InvalidInput("a landmark is no vertex of the surfaces");
    if (used[s]) throw InvalidInput("a source vertex has two landmarks");
    used[s] = true;
  }
}

/// The target, the source, and the source's mirror image if that may match as well.
std::vector<Model> make_models(const Shape& source, const Shape& target, bool with_mirror,
                               const TrackerOptions& options, const Context& context) {
  struct Request {
    const Shape* shape;
    bool mirrored;
  };
  std::vector<Request> requests{{&target, false}, {&source, false}};
  if (with_mirror) requests.push_back({&source, true});
  Context alone;
  alone.threads = 1;
  std::vector<std::optional<Model>> made(requests.size());
#pragma omp parallel for schedule(dynamic) num_threads(context.threads)
  for (std::size_t k = 0; k < requests.size(); ++k)
    made[k].emplace(make_model(*requests[k].shape, requests[k].mirrored, options, alone));
  std::vector<Model> models;
  for (auto& model : made) models.push_back(std::move(*model));
  return models;
}

}  // namespace

void TrackedOptions::validate() const {
  if (alternatives < 0) throw InvalidInput("alternatives must not be negative");
}

TrackedResult match_tracked(const Shape& source, const Shape& target, const TrackedOptions& options,
                            const Context& context) {
  options.validate();
  check_landmarks(options.landmarks, source, target);
  const TrackerOptions tracking = tracker_options(options);
  TrackedResult result;
  const auto timed = [&](std::string_view stage, double begun, const auto& work) {
    context.report(begun, stage);
    const StageTimer timer(result.times, stage);
    return work();
  };
  const std::vector<Model> models = timed("shapes", 0.0, [&] {
    return make_models(source, target, options.allow_reflection, tracking, context);
  });
  result.oriented = models[0].proxy.oriented && models[1].proxy.oriented;
  const std::vector<Judged> judged = timed("hypotheses", 0.4, [&] {
    std::vector<Judged> all;
    for (std::size_t k = 1; k < models.size(); ++k)
      std::ranges::move(judged_hypotheses(models[k], models[0], tracking, context),
                        std::back_inserter(all));
    if (models.size() > 2) sort_by_cost(all);
    return all;
  });
  if (judged.empty())
    throw InvalidInput("the shapes have too little in common: there is no hypothesis to follow");
  for (const Judged& j : judged)
    result.hypotheses.push_back({j.hypothesis.distortion, j.hypothesis.orientation, j.energy});
  const Finals finals =
      timed("refinement", 0.6, [&] { return run_finals(models[0], judged, tracking, context); });
  result.confidence = finals.confidence;
  timed("dense map", 0.9, [&] {
    for (const Track& track : finals.tracks) {
      if (std::cmp_greater(result.maps.size(), options.alternatives)) break;
      result.maps.push_back(dense_map(track, models[0], tracking, context));
    }
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
