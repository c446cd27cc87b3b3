// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/reversal.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tracked/tracks/deformed_surface.h"

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

/// Where the nodes of the source are on the target, since the target came to lie on them.
std::vector<Point> places_below(const Level& nodes, const Proxy& source, const Proxy& target,
                                const Track& reverse, const elastic::ProjectionWeights& weights) {
  DeformedSurface deformed = deformed_surface(target, reverse.deformation, reverse.cloud);
  const Mesh mesh{std::move(deformed.positions), target.mesh.faces};
  const elastic::Projection onto(mesh, target.faces, deformed.normals, deformed.features, weights);
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
  std::vector<Point> anchors =
      places_below(*track.source, track.judged.source->proxy, target.proxy, reverse,
                   options.last_projection(track.judged.hypothesis.pose.has_value()));
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (!track.cloud.is_inside(static_cast<int>(i))) {
      anchors[i] = track.deformation.positions()[i];
      continue;
    }
    const Point& own = track.registration.feet[i].position;
    anchors[i] =
        (anchors[i] - own).norm() < options.max_disagreement ? Point((anchors[i] + own) / 2) : own;
  }
  elastic::Registration judged = track.registration;
  refinement.settle(track, anchors);
  judged.feet = std::move(track.registration.feet);
  track.registration = std::move(judged);
}

}  // namespace isomatch::tracked
