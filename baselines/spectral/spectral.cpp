// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/spectral.h"

#include <algorithm>
#include <cmath>

#include "isomatch/error.h"
#include "spectral/eigenvector_order.h"
#include "spectral/embedding.h"
#include "spectral/nearest_rows.h"
#include "spectral/thin_plate.h"

namespace isomatch::baselines {
namespace {

std::vector<int> nearest(const Eigen::MatrixXd& queries, const Eigen::MatrixXd& points,
                         const Context& context) {
  return isomatch::spectral::nearest_rows(queries.cast<float>(), points.cast<float>(), context);
}

/// Non-rigid ICP: moves `source` onto `target`.
void align(Embedding& source, const Embedding& target, const SpectralOptions& options,
           const Context& context) {
  for (int round = 0; round < options.rounds; ++round) {
    context.check_stop();
    const double share = round / std::max(1.0, options.rounds - 1.0);
    const double smoothing =
        options.first_smoothing * std::pow(options.last_smoothing / options.first_smoothing, share);
    const Eigen::MatrixXd goals =
        target.bases(nearest(source.bases, target.bases, context), Eigen::all);
    const ThinPlateSpline spline(source.bases, goals, smoothing);
    source = {spline(source.bases), spline(source.vertices)};
  }
}

}  // namespace

void SpectralOptions::validate() const {
  if (dimensions < 1 || dimensions > 6) throw InvalidInput("dimensions must be in [1, 6]");
  if (rounds < 0) throw InvalidInput("rounds must not be negative");
  if (!(last_smoothing > 0 && first_smoothing >= last_smoothing))
    throw InvalidInput("smoothing must be positive and must not rise");
}

SpectralResult match_spectral(const MetricSurface& source, const MetricSurface& target,
                              const JointSampling& bases, const SpectralOptions& options,
                              const Context& context) {
  options.validate();
  if (std::min(std::ssize(bases.source), std::ssize(bases.target)) <= options.dimensions)
    throw InvalidInput("the spectral method needs more base vertices than dimensions");
  Embedding on_source = embed(source, bases.source, options.dimensions, context);
  const Embedding on_target = embed(target, bases.target, options.dimensions, context);
  const SignedOrder order = best_signed_order(on_source.bases, on_target.bases, context);
  on_source = {order.applied(on_source.bases), order.applied(on_source.vertices)};
  align(on_source, on_target, options, context);
  return {nearest(on_source.bases, on_target.bases, context),
          nearest(on_source.vertices, on_target.vertices, context)};
}

}  // namespace isomatch::baselines
