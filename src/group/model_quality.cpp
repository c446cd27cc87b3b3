// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "group/left_out.h"
#include "group/principal_axes.h"
#include "isomatch/error.h"
#include "isomatch/group/shape_model.h"
#include "random.h"

namespace isomatch {
namespace {

std::vector<double> compactness_of(const PrincipalAxes& axes, Eigen::Index count) {
  std::vector<double> shares;
  double sum = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    sum += axes.variances[k];
    shares.push_back(sum / axes.variances.sum());
  }
  return shares;
}

std::vector<double> generalisation_of(const PrincipalAxes& axes, Eigen::Index count,
                                      double num_points) {
  const Eigen::Index num_shapes = axes.scores.rows();
  if (count == 0) return {};
  if (num_shapes < 3) return std::vector<double>(count, std::numeric_limits<double>::quiet_NaN());
  std::vector<double> means(count, 0.0);
  const auto others = static_cast<double>(num_shapes - 1);
  // From the mean of the others, s is this much longer.
  const double factor = static_cast<double>(num_shapes) / others;
  const Eigen::VectorXd squares = others * axes.variances;
  for (Eigen::Index i = 0; i < num_shapes; ++i) {
    const Eigen::VectorXd scores = axes.scores.row(i).transpose();
    const std::vector<double> parts = LeftOut(squares, scores, factor).parts();
    double rest = scores.squaredNorm();
    for (Eigen::Index k = 0; k < count; ++k) {
      rest = std::max(0.0, rest - parts[k]);
      means[k] += factor * std::sqrt(rest / num_points) / static_cast<double>(num_shapes);
    }
  }
  return means;
}

/// Normally distributed, in pairs (Box and Muller 1958).
class NormalNumbers {
 public:
  explicit NormalNumbers(Random random) : random_(random) {}

  double next() {
    has_second_ = !has_second_;
    if (!has_second_) return second_;
    const double radius = std::sqrt(-2 * std::log(1 - random_.uniform()));
    const double angle = 2 * std::numbers::pi * random_.uniform();
    second_ = radius * std::sin(angle);
    return radius * std::cos(angle);
  }

 private:
  Random random_;
  bool has_second_ = false;
  double second_ = 0;
};

std::vector<double> specificity_of(const PrincipalAxes& axes, Eigen::Index count, double num_points,
                                   int samples, unsigned seed) {
  std::vector<double> means(count, 0.0);
  NormalNumbers normal(Random{seed});
  const Eigen::VectorXd from_mean = axes.scores.rowwise().squaredNorm();
  for (int sample = 0; sample < samples; ++sample) {
    // Of all shapes from the sample with its first modes, the others being 0.
    Eigen::VectorXd squares = from_mean;
    for (Eigen::Index k = 0; k < count; ++k) {
      const double score = std::sqrt(axes.variances[k]) * normal.next();
      squares.array() += score * score - 2 * score * axes.scores.col(k).array();
      const double nearest = std::max(0.0, squares.minCoeff());
      means[k] += std::sqrt(nearest / num_points) / samples;
    }
  }
  return means;
}

}  // namespace

ModelQuality model_quality(const ShapeModel& model, int samples, unsigned seed) {
  if (samples < 1) throw InvalidInput("the quality of a model needs samples");
  // Modes that the model leaves out count as well.
  const ShapeRows rows = model.aligned;
  const Eigen::RowVectorXd mean = rows.colwise().mean();
  const PrincipalAxes axes = principal_axes(deviations_from(mean, rows), least_variance(mean));
  const Eigen::Index count = std::min(model.modes.rows(), axes.variances.size());
  const auto num_points = static_cast<double>(model.mean.size());
  return {compactness_of(axes, count), generalisation_of(axes, count, num_points),
          specificity_of(axes, count, num_points, samples, seed)};
}

}  // namespace isomatch
