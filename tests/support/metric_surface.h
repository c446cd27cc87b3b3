// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "shape/prepared_shape.h"

namespace isomatch::test {

/// The surface of a mesh with its geodesics, in the surface's numbers. Includers see `src`.
inline MetricSurface metric_surface(const Mesh& mesh, const GeodesicOptions& geodesics = {},
                                    const Context& context = {}) {
  return PreparedShape(mesh, geodesics).metric(context);
}

}  // namespace isomatch::test
