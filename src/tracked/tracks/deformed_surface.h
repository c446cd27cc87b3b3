// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "elastic/deformation.h"
#include "isomatch/context.h"
#include "tracked/shape/pyramid.h"

namespace isomatch::tracked {

/// For each vertex of the detail that of the first so many nodes in whose Voronoi cell it lies.
/// O(N log N).
std::vector<int> detail_cells(const Pyramid& pyramid, int nodes);

/// A deformed surface: positions and normals of its vertices, and, of those that have features, the
/// relief at rest and the places on the target where they went.
struct DeformedSurface {
  std::vector<Point> positions, normals;
  std::vector<elastic::Features> features;
  /// Of the vertices, how much of what is around them has a counterpart, in [0, 1].
  std::vector<double> inside;
  /// Of the vertices, elastic energy over area.
  std::vector<double> strain;
};

/// A surface that has not been deformed, all of which has a counterpart.
DeformedSurface at_rest(std::vector<Point> positions, std::vector<Point> normals,
                        std::vector<elastic::Features> features);

/// Carries a deformation of the first nodes of a pyramid, and the places where they went, over to
/// all vertices of its surface; features are those of the detail. O(N log N).
DeformedSurface deformed_surface(const Pyramid& pyramid, const elastic::Deformation& deformation,
                                 const elastic::PointCloud& nodes, const Context& context);

/// The same for all vertices of a proxy.
DeformedSurface deformed_surface(const Proxy& proxy, const elastic::Deformation& deformation,
                                 const elastic::PointCloud& nodes);

}  // namespace isomatch::tracked
