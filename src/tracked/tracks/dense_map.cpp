// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/dense_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elastic/nearest_point.h"
#include "geometry/closest_point.h"
#include "geometry/walk.h"
#include "parallel.h"
#include "tracked/tracks/deformed_surface.h"
#include "tracked/tracks/unfolding.h"

namespace isomatch::tracked {
namespace {

/// A surface, as it is or deformed, one of which is to be mapped to the other.
struct Side {
  const Pyramid& pyramid;
  const DeformedSurface& deformed;
};

/// For each vertex of the detail of `from` the closest one of the detail of `onto` in position,
/// normal and features, as vertices of the surface.
std::vector<int> closest_details(const Side& from, const Side& onto,
                                 const elastic::ProjectionWeights& weights,
                                 const Context& context) {
  const std::vector<int>& queries = from.pyramid.detail.surface_vertex;
  const std::vector<int>& vertices = onto.pyramid.detail.surface_vertex;
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

/// Whether a vertex has a counterpart at a point that is closest to it: what is around both has
/// one, and it is not the rim that is closest to what lies beyond.
bool has_counterpart(const Side& from, const Side& onto, const Mesh& mesh, int vertex,
                     const SurfacePoint& point, const Options& options) {
  const double least = options.partial.least_inside;
  if (from.deformed.inside[vertex] < least) return false;
  double inside = 0;
  bool on_rim = true;
  for (int k = 0; k < 3; ++k) {
    const int v = mesh.faces[point.face][k];
    inside += point.weights[k] * onto.deformed.inside[v];
    on_rim = on_rim && (point.weights[k] == 0 || std::ranges::binary_search(onto.pyramid.rim, v));
  }
  const double distance = (position(mesh, point) - from.deformed.positions[vertex]).norm();
  return inside >= least && distance <= (on_rim ? options.partial.beyond : options.partial.reach);
}

/// Points of `onto` that are closest in space, found from those of the details.
SurfacePoints project(const Side& from, const Side& onto, const elastic::ProjectionWeights& weights,
                      const Options& options, const Context& context) {
  const std::vector<int> starts = closest_details(from, onto, weights, context);
  const Surface& surface = *onto.pyramid.surface;
  const Mesh mesh{onto.deformed.positions, surface.mesh.faces};
  SurfaceMap map(from.deformed.positions.size());
  parallel_for(std::ssize(map), context, [&](std::ptrdiff_t v) {
    const Point& p = from.deformed.positions[v];
    const int vertex = walk_to_vertex(mesh, surface.faces, starts[from.pyramid.anchors[v]], p);
    map[v] = closest_point_around(mesh, surface.faces, vertex, p);
    if (options.parts && !has_counterpart(from, onto, mesh, static_cast<int>(v), map[v], options))
      map[v] = {};
  });
  return SurfacePoints(std::move(map));
}

/// How sure points are: logistic in how much the source is strained there, how much of what is
/// around has a counterpart, and how well the whole fits, what is left out included. The numbers
/// are those of a logistic regression on whether matches of 27 development pairs (pieces, animals,
/// people, fused poses) are within .05 of the truth; bench/tables/partial.py tells how often those
/// of all pairs are. How far the surfaces are apart did not tell.
std::vector<float> confidence(const Side& from, const Side& onto, const SurfacePoints& map,
                              const Track& track) {
  constexpr double kBias = -12.17, kStrain = -0.37, kInside = 3, kWhole = -1.14;
  const double whole =
      kWhole * std::log((track.registration.energy + track.energy_left_out) *
                            (track.registration.distance + track.distance_left_out) +
                        1e-7);
  std::vector<float> result(map->size(), 0.0F);
  for (std::size_t v = 0; v < result.size(); ++v) {
    const SurfacePoint& point = (*map)[v];
    if (point.face == kNoFace) continue;
    double strain = from.deformed.strain[v], inside = from.deformed.inside[v];
    const Face& face = onto.pyramid.surface->mesh.faces[point.face];
    double onto_inside = 0;
    for (int k = 0; k < 3; ++k) {
      strain += point.weights[k] * onto.deformed.strain[face[k]];
      onto_inside += point.weights[k] * onto.deformed.inside[face[k]];
    }
    const double evidence =
        kBias + kStrain * std::log(strain + 0.01) + kInside * std::min(inside, onto_inside) + whole;
    result[v] = static_cast<float>(1 / (1 + std::exp(-evidence)));
  }
  return result;
}

/// Moves what is near a landmark along with it, so that the landmark arrives.
void bend_to_landmarks(const Pyramid& source, const Pyramid& target,
                       const SurfaceMatches& landmarks, double reach, DeformedSurface& deformed) {
  std::vector<Point> moves;
  for (const Match& match : *landmarks)
    moves.push_back(target.surface->mesh.vertices[match.target] - deformed.positions[match.source]);
  const std::vector<Point>& rest = source.surface->mesh.vertices;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    for (std::size_t k = 0; k < landmarks->size(); ++k) {
      const double distance = (rest[v] - rest[(*landmarks)[k].source]).norm() / reach;
      deformed.positions[v] += std::exp(-distance * distance) * moves[k];
    }
  }
}

}  // namespace

DenseMap dense_map(const Track& track, const Pyramid& target, const Options& options,
                   const Context& context) {
  const Pyramid& source = *track.judged.source;
  const Surface& goal = *target.surface;
  DeformedSurface deformed = deformed_surface(source, track.deformation, track.cloud, context);
  bend_to_landmarks(source, target, options.landmarks, options.landmark_reach, deformed);
  const DeformedSurface rest = at_rest(goal.mesh.vertices, goal.normals, target.detail.features);
  const Side from{source, deformed}, onto{target, rest};
  const elastic::ProjectionWeights& weights =
      options.last_projection(track.judged.hypothesis.pose.has_value());
  DenseMap map{project(from, onto, weights, options, context),
               project(onto, from, weights, options, context),
               {},
               {},
               {},
               {}};
  map.source_confidence = confidence(from, onto, map.source_to_target, track);
  map.target_confidence = confidence(onto, from, map.target_to_source, track);
  map.registered = std::move(deformed.positions);
  for (const Match& match : *options.landmarks)
    (*map.source_to_target)[match.source] =
        closest_point_around(goal.mesh, goal.faces, match.target, goal.mesh.vertices[match.target]);
  std::vector<int> landed;
  for (const Match& match : *options.landmarks) landed.push_back(match.source);
  map.unfolded =
      unfolded(*source.surface, map.registered, goal,
               {*map.source_to_target, *map.target_to_source}, landed, options.unfolding, context);
  return map;
}

}  // namespace isomatch::tracked
