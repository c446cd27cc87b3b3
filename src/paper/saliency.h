// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/methods/sampling.h"
#include "shape/metric_surface.h"

namespace isomatch {

/// Integral geodesic distance of Hilaga et al. 2001: the integral of g(v, p) over p on the surface,
/// divided by the area and the largest geodesic distance, so in [0, 1]. Large at extremities. One
/// value a vertex. O(integral_points N log N).
std::vector<double> integral_geodesic_distance(const MetricSurface& shape,
                                               const SaliencyOptions& options = {},
                                               const Context& context = {});

/// Gaussian curvature at each vertex: angle defects, spread by heat flow to `curvature_scale`,
/// times the area of the surface. The angle defect of a boundary vertex counts as zero. One value a
/// vertex. One sparse system solved by conjugate gradients.
std::vector<double> gaussian_curvature(const MetricSurface& shape,
                                       const SaliencyOptions& options = {});

}  // namespace isomatch
