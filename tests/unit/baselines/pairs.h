// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <utility>
#include <vector>

#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/synth.h"
#include "isomatch/shape/shape.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"
#include "support/random.h"
#include "support/transforms.h"

namespace isomatch::test {

/// Two shapes whose correspondence is known.
struct KnownPair {
  Shape source, target;
  GroundTruth truth;

  MetricSurface source_surface() const { return source.prepared().metric({}); }
  MetricSurface target_surface() const { return target.prepared().metric({}); }

  /// Mean error, over sqrt(area).
  double error(const Correspondence& matches) const {
    return template_errors(source, target, truth, matches).mean;
  }
  /// Of what is in the numbers of the surfaces.
  double error(const SurfaceMatches& matches) const {
    return error(to_input(*source.prepared().surface(), *target.prepared().surface(), matches));
  }
};

/// The matches of a map between surfaces.
inline SurfaceMatches surface_matches(const VertexMap& map) {
  return SurfaceMatches(to_correspondence(map));
}

/// A bent creature, and itself moved and under other numbers.
inline KnownPair relabelled_pair(int vertices) {
  Random random(1);
  const Mesh mesh = synthesize({.vertices = vertices, .pose = 1, .seed = 2}).mesh;
  const Relabelled other = relabelled(moved(mesh, random), random);
  std::vector<int> all(mesh.vertices.size());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
  return {Shape(mesh), Shape(other.mesh), {all, other.new_vertex}};
}

/// A creature in two poses that are close to each other in geodesic distance, each meshed anew.
inline KnownPair posed_pair(int vertices) {
  const SynthShape source = synthesize({.vertices = vertices, .pose = 1, .seed = 2});
  const SynthShape target = synthesize({.vertices = vertices, .pose = 2, .seed = 2});
  return {Shape(source.mesh), Shape(target.mesh), {source.ground_truth, target.ground_truth}};
}

}  // namespace isomatch::test
