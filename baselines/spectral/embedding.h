// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <span>

#include "isomatch/context.h"
#include "shape/metric_surface.h"

namespace isomatch::baselines {

/// A shape in the spectral domain, a point a row.
struct Embedding {
  Eigen::MatrixXd bases;
  /// Of all vertices, by the Nystroem extension; those of bases are where `bases` has them.
  Eigen::MatrixXd vertices;
};

/// The leading eigenvectors of the affinity exp(-g^2 / 2 sigma^2) between `bases`, after the first,
/// nearly constant one, each times the square root of its eigenvalue; sigma is the largest g. Fewer
/// dimensions than wanted where there are too few bases. Signs are arbitrary.
Embedding embed(const MetricSurface& shape, std::span<const int> bases, int dimensions,
                const Context& context);

}  // namespace isomatch::baselines
