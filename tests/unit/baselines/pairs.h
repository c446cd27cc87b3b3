// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <utility>
#include <vector>

#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/shape.h"
#include "isomatch/mesh/synth.h"
#include "support/random.h"
#include "support/transforms.h"

namespace isomatch::test {

/// Two shapes whose correspondence is known.
struct KnownPair {
  Shape source, target;
  GroundTruth truth;

  /// Mean error, over sqrt(area).
  double error(const Correspondence& matches) const {
    return template_errors(target, truth, matches).mean;
  }
  double error(const VertexMap& map) const { return error(to_correspondence(map)); }
};

/// A bent creature, and itself moved and under other numbers.
inline KnownPair relabelled_pair(int vertices) {
  Random random(1);
  const Mesh mesh = synthesize({.vertices = vertices, .pose = 1, .seed = 2}).mesh;
  const Relabelled other = relabelled(moved(mesh, random), random);
  std::vector<int> all(mesh.vertices.size());
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
  KnownPair pair{prepare_shape(mesh), prepare_shape(other.mesh), {}};
  pair.truth = surface_truth(pair.source.surface, pair.target.surface, all, other.new_vertex);
  return pair;
}

/// A creature in two poses that are close to each other in geodesic distance, each meshed anew.
inline KnownPair posed_pair(int vertices) {
  const SynthShape source = synthesize({.vertices = vertices, .pose = 1, .seed = 2});
  const SynthShape target = synthesize({.vertices = vertices, .pose = 2, .seed = 2});
  KnownPair pair{prepare_shape(source.mesh), prepare_shape(target.mesh), {}};
  pair.truth = surface_truth(pair.source.surface, pair.target.surface, source.ground_truth,
                             target.ground_truth);
  return pair;
}

}  // namespace isomatch::test
