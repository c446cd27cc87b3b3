// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/shape/shape.h"

/// Which vertices stand out, and evenly spread base vertices (Section 3 of the paper). What has one
/// value a vertex is NaN where a vertex is not part of the surface.
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
std::vector<double> gaussian_curvature(const Shape& shape, const SaliencyOptions& options = {},
                                       const Context& context = {});

/// Vertices in descending order of saliency, ties to the lower index; without those that have none
/// (NaN).
std::vector<int> descending_order(std::span<const double> saliency);

/// Adds to none the first vertex of `order` that is not within `radius`, in units of the mesh, of
/// a vertex chosen before, until all are. Vertices of `order` must be part of the surface. With
/// radius 0 all are chosen. Throws `InvalidInput` if a vertex is not, or the radius is
/// negative. Cost: one ball a base.
std::vector<int> sample_bases(const Shape& shape, std::span<const int> order, double radius,
                              const Context& context = {});

}  // namespace isomatch
