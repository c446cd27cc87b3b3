// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/mesh/shape.h"

namespace isomatch {

struct SaliencyOptions {
  /// Evenly spaced points that stand for the surface in the integral geodesic distance. Hilaga et
  /// al. use about 150.
  int integral_points = 150;
  /// Standard deviation of the smoothing of the Gaussian curvature, relative to sqrt(area). The
  /// paper names no scale; at that of single edges the order of the vertices is that of the
  /// meshing, and the samplings of two shapes have little in common.
  double curvature_scale = 0.03;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

/// Integral geodesic distance of Hilaga et al. 2001: the integral of g(v, p) over p on the surface,
/// divided by the area and the largest geodesic distance, so in [0, 1]. Large at extremities. One
/// value a vertex. O(integral_points N log N).
std::vector<double> integral_geodesic_distance(const Shape& shape,
                                               const SaliencyOptions& options = {},
                                               const Context& context = {});

/// Gaussian curvature at each vertex: angle defects, spread by heat flow to `curvature_scale`,
/// times the area of the surface. The angle defect of a boundary vertex counts as zero. One value a
/// vertex. One sparse system solved by conjugate gradients.
std::vector<double> gaussian_curvature(const Shape& shape, const SaliencyOptions& options = {});

/// Vertices in descending order of saliency, ties to the lower index.
std::vector<int> descending_order(const std::vector<double>& saliency);

}  // namespace isomatch
