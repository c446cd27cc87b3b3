// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "elastic/deformation.h"
#include "tracked/proxy.h"

namespace isomatch::tracked {

/// A deformed surface: positions and normals of its vertices, their relief at rest, and the places
/// on the target where they went.
struct DeformedSurface {
  std::vector<Point> positions, normals;
  std::vector<elastic::Features> features;
};

/// Carries a deformation of the nodes of `proxy`, and where they went, over to all vertices of
/// `surface`. O(N log N).
DeformedSurface transfer(const Shape& shape, const UnitSurface& surface, const Proxy& proxy,
                         const elastic::Deformation& deformation,
                         const std::vector<elastic::Features>& node_features);

}  // namespace isomatch::tracked
