// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/reversal.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/interpolation.h"
#include "parallel.h"
#include "tracked/tracks/deformed_surface.h"
#include "tracked/tracks/sliding.h"

namespace isomatch::tracked {
namespace {

Options reversed(Options options) {
  for (Match& match : *options.landmarks) std::swap(match.source, match.target);
  return options;
}

/// The target, registered onto the source.
Track reverse_track(const Track& track, const Refinement& refinement, const Pyramid& target,
                    const Options& options, const Context& context) {
  const Pyramid& source = *track.judged.source;
  Judged judged = track.judged;
  judged.source = &target;
  const std::vector<int> nearest = refinement.nearest_nodes(track);
  return Refinement(source, options, context)
      .fine_rounds(judged, node_vertices(source.proxy, nearest),
                   refinement.covered_target(track, nearest),
                   std::max(0, options.rounds - options.reverse_rounds));
}

/// Where the vertices of a track's proxy are on the other one, as both curve.
SurfaceMap images(const Track& track, const Proxy& onto, const elastic::Projection& surface,
                  const Options& options) {
  const Proxy& proxy = track.judged.source->proxy;
  const DeformedSurface deformed = deformed_surface(proxy, track.deformation, track.cloud);
  SurfaceMap images;
  for (int v = 0; v < proxy.num_vertices(); ++v)
    images.push_back(
        surface(deformed.positions[v], deformed.normals[v], deformed.features[v]).point);
  // What hardly bends lies where it is closest, and may be too full of holes to curve.
  if (track.judged.hypothesis.pose || !proxy.oriented || !onto.oriented) return images;
  std::vector<bool> inside;
  for (int v = 0; !track.cloud.inside.empty() && v < proxy.num_vertices(); ++v)
    inside.push_back(track.cloud.inside[track.source->graph.cell[v]]);
  return slid(proxy, onto, std::move(images), inside, options.sliding);
}

/// A proxy whose vertices lie on another one, with the normals and the places there.
struct Laid {
  Mesh mesh;
  std::vector<Point> normals;
  std::vector<elastic::Features> features;
};

Laid laid(const Proxy& proxy, const Proxy& onto, const SurfaceMap& images) {
  Laid result{{{}, proxy.mesh.faces}, {}, proxy.features};
  for (std::size_t v = 0; v < images.size(); ++v) {
    const auto& [face, weights] = images[v];
    result.mesh.vertices.push_back(position(onto.mesh, images[v]));
    result.normals.push_back(interpolated(onto.mesh, onto.normals, images[v]).stableNormalized());
    result.features[v].place = {};
    for (int k = 0; k < 3; ++k) {
      const int corner = onto.mesh.faces[face][k];
      for (int p = 0; p < elastic::kPlaces; ++p)
        result.features[v].place[p] += weights[k] * onto.features[corner].place[p];
    }
  }
  return result;
}

/// Where the nodes of the source are on the target, since the target's vertices have images on it.
std::vector<Point> places_below(const Level& nodes, const Proxy& source, const Proxy& target,
                                const SurfaceMap& images,
                                const elastic::ProjectionWeights& weights) {
  const Laid below = laid(target, source, images);
  const elastic::Projection onto(below.mesh, target.faces, below.normals, below.features, weights);
  std::vector<Point> places;
  for (int i = 0; i < nodes.size(); ++i) {
    const elastic::Foot foot =
        onto(source.node_position(i), source.node_normal(i), source.features[source.nodes[i]]);
    places.push_back(position(target.mesh, foot.point));
  }
  return places;
}

}  // namespace

void settle_with_reverse(Track& track, const Refinement& refinement, const Pyramid& target,
                         const Options& options, const Context& context) {
  const Track reverse = reverse_track(track, refinement, target, reversed(options), context);
  const Proxy& source = track.judged.source->proxy;
  const elastic::ProjectionWeights& weights =
      options.last_projection(track.judged.hypothesis.pose.has_value());
  SurfaceMap there, back;
  parallel_for(2, context, [&](std::ptrdiff_t direction) {
    if (direction == 0)
      there = images(track, target.proxy, projection_onto(target.proxy, weights), options);
    else
      back = images(reverse, source, projection_onto(source, weights), options);
  });
  std::vector<Point> anchors = places_below(*track.source, source, target.proxy, back, weights);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (!track.cloud.is_inside(static_cast<int>(i))) {
      anchors[i] = track.deformation.positions()[i];
      continue;
    }
    const Point own = position(target.proxy.mesh, there[source.nodes[i]]);
    anchors[i] =
        (anchors[i] - own).norm() < options.max_disagreement ? Point((anchors[i] + own) / 2) : own;
  }
  elastic::Registration judged = track.registration;
  refinement.settle(track, anchors);
  judged.feet = std::move(track.registration.feet);
  track.registration = std::move(judged);
}

}  // namespace isomatch::tracked
