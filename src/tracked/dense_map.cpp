// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/dense_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elastic/nearest_point.h"
#include "geometry/closest_point.h"
#include "geometry/walk.h"
#include "parallel.h"
#include "tracked/transfer.h"

namespace isomatch::tracked {
namespace {

/// A surface, as it is or deformed, one of which is to be mapped to the other.
struct Side {
  const Model& model;
  const DeformedSurface& deformed;
};

/// For each vertex of the detail of `from` the closest one of the detail of `onto` in position,
/// normal and features, as vertices of the surface.
std::vector<int> closest_details(const Side& from, const Side& onto,
                                 const elastic::ProjectionWeights& weights,
                                 const Context& context) {
  const std::vector<int>& queries = from.model.detail.surface_vertex;
  const std::vector<int>& vertices = onto.model.detail.surface_vertex;
  const elastic::NearestPoint nearest(selected(onto.deformed.positions, vertices),
                                      selected(onto.deformed.normals, vertices),
                                      onto.deformed.features, weights);
  std::vector<int> closest(queries.size());
  parallel_for(std::ssize(queries), context, [&](std::ptrdiff_t d) {
    closest[d] = vertices[nearest(from.deformed.positions[queries[d]],
                                  from.deformed.normals[queries[d]], from.deformed.features[d])];
  });
  return closest;
}

/// The same point with the faces as they are in the surface.
SurfacePoint in_surface(SurfacePoint point, const UnitSurface& surface) {
  if (surface.turned[point.face]) std::swap(point.weights[1], point.weights[2]);
  return point;
}

/// Points of `onto` that are closest in space, found from those of the details.
SurfaceMap project(const Side& from, const Side& onto, const elastic::ProjectionWeights& weights,
                   const Context& context) {
  const std::vector<int> starts = closest_details(from, onto, weights, context);
  const UnitSurface& surface = onto.model.surface;
  const Mesh mesh{onto.deformed.positions, surface.mesh.faces};
  SurfaceMap map(from.deformed.positions.size());
  parallel_for(std::ssize(map), context, [&](std::ptrdiff_t v) {
    const Point& p = from.deformed.positions[v];
    const int vertex = walk_to_vertex(mesh, surface.faces, starts[from.model.anchors[v]], p);
    map[v] = in_surface(closest_point_around(mesh, surface.faces, vertex, p), surface);
  });
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

}  // namespace

TrackedMap dense_map(const Track& track, const Model& target, const TrackerOptions& options,
                     const Context& context) {
  const Model& source = *track.judged.source;
  const UnitSurface& goal = target.surface;
  DeformedSurface deformed = transfer(source, track.deformation, track.cloud.features, context);
  bend_to_landmarks(source, target, options.landmarks, deformed);
  const DeformedSurface rest{goal.mesh.vertices, goal.normals, target.detail.features};
  const Side from{source, deformed}, onto{target, rest};
  TrackedMap map;
  map.source_to_target = project(from, onto, options.fine_projection, context);
  map.target_to_source = project(onto, from, options.fine_projection, context);
  for (const Match& match : options.landmarks)
    map.source_to_target[match.source] = in_surface(
        closest_point_around(goal.mesh, goal.faces, match.target, goal.mesh.vertices[match.target]),
        goal);
  map.registered = std::move(deformed.positions);
  for (Point& p : map.registered) p = p * goal.scale + goal.centre;
  map.energy = track.registration.energy;
  map.distance = track.registration.distance;
  map.deviation = track.registration.deviation;
  map.distortion = track.judged.hypothesis.distortion;
  map.orientation = track.judged.hypothesis.orientation;
  map.mirrored = source.mirrored;
  return map;
}

}  // namespace isomatch::tracked
