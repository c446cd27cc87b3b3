// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"
#include "random.h"

namespace isomatch::synth {

struct HoleOptions {
  int count;
  /// Along the surface, in units of the coordinates.
  double radius;
  /// Vertices, one of which is in the middle of each hole; `kUnmatched` among them is passed over.
  std::vector<int> middles;
};

/// Removes the faces of round holes at random places, a radius or more apart from each other and
/// from borders. The vertices stay. Throws `InvalidInput` if there is no room for as many. O(N).
Mesh make_holes(Mesh mesh, HoleOptions options, Random& random, const Context& context);

}  // namespace isomatch::synth
