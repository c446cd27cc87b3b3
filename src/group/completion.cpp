// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/completion.h"

#include <Eigen/LU>
#include <algorithm>
#include <functional>
#include <limits>

#include "group/principal_axes.h"

namespace isomatch {
namespace {

/// How shapes are distributed: along a few axes, and with the same noise in all coordinates.
struct Distribution {
  Eigen::RowVectorXd mean;
  PrincipalAxes axes;
  /// A few of the axes, count x 3P.
  Eigen::MatrixXd directions;
  double noise = 0;
};

/// 1 where a shape has a coordinate, 0 where it lacks it.
ShapeRows known_coordinates(const CorrespondingPoints& shapes) {
  const Eigen::Index num_points = std::ssize(shapes.points.front());
  ShapeRows known(std::ssize(shapes.points), 3 * num_points);
  for (Eigen::Index i = 0; i < known.rows(); ++i)
    for (Eigen::Index p = 0; p < num_points; ++p)
      known.row(i).segment<3>(3 * p).setConstant(shapes.present[i][p] ? 1 : 0);
  return known;
}

/// With the number of axes, at most `most`, and the noise that generalised cross-validation (Josse
/// and Husson 2012) of the coordinates that are known tells. Others would fit noise, and what was
/// filled in, and spoil what is filled in next.
Distribution distribution_of(const ShapeRows& rows, const ShapeRows& known, Eigen::Index most) {
  Distribution result;
  result.mean = rows.colwise().mean();
  const ShapeRows deviations = deviations_from(result.mean, rows);
  const double least = least_variance(result.mean);
  result.axes = principal_axes(deviations, least);
  most = std::min(most, result.axes.variances.size());
  const Eigen::MatrixXd directions = axis_directions(deviations, result.axes, most);
  // Against dividing by nothing, where shapes have no noise.
  constexpr double kLeastNoise = 1e-9;
  const auto size = static_cast<double>(rows.cols()), num_shapes = static_cast<double>(rows.rows());
  const double least_noise = (least + kLeastNoise * result.axes.variances.sum()) / size;
  result.directions = directions.topRows(0);
  result.noise = least_noise;
  ShapeRows rest = deviations.cwiseProduct(known);
  const double num_known = known.sum();
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k <= most; ++k) {
    const auto count = static_cast<double>(k);
    const double freedom = num_known - size - count * (num_shapes - 1 + size - count);
    if (freedom <= 0) break;
    const double noise = std::max(rest.squaredNorm() / freedom, least_noise);
    if (noise / freedom < best) {
      best = noise / freedom;
      result.noise = noise;
      result.directions = directions.topRows(k);
    }
    if (k < most) rest -= known.cwiseProduct(result.axes.scores.col(k) * directions.row(k));
  }
  return result;
}

/// Coordinates of the points that a shape has.
std::vector<Eigen::Index> own_coordinates(const std::vector<bool>& present) {
  std::vector<Eigen::Index> coordinates;
  for (std::size_t p = 0; p < present.size(); ++p)
    for (int k = 0; k < 3 && present[p]; ++k)
      coordinates.push_back(static_cast<Eigen::Index>(3 * p + k));
  return coordinates;
}

/// What the other shapes say of one from a part of its points.
class Predictor {
 public:
  /// `row` is the shape as it is taken to be so far, and a part of the distribution.
  Predictor(const Distribution& all, const Eigen::RowVectorXd& row, Eigen::Index shape,
            const std::vector<Eigen::Index>& own)
      : all_(all), own_(own) {
    const auto num_shapes = static_cast<double>(all.axes.scores.rows());
    const Eigen::Index count = all.directions.rows();
    mean_ = all.mean + (all.mean - row) / (num_shapes - 1);
    own_directions_ = all.directions(Eigen::all, own);
    const Eigen::VectorXd score = all.axes.scores.row(shape).head(count).transpose();
    covariance_ = (num_shapes - 1) * all.axes.variances.head(count).asDiagonal();
    covariance_ -= num_shapes / (num_shapes - 1) * score * score.transpose();
    covariance_ /= std::max(1.0, num_shapes - 2);
    const Eigen::MatrixXd products = own_directions_ * own_directions_.transpose();
    solver_.compute(products * covariance_ + all.noise * Eigen::MatrixXd::Identity(count, count));
  }

  /// All coordinates, given those that it has.
  Eigen::RowVectorXd predict(const Eigen::RowVectorXd& given) const {
    if (all_.directions.rows() == 0) return mean_;
    const Eigen::RowVectorXd rest = given - mean_(own_);
    const Eigen::VectorXd score =
        covariance_ * solver_.solve(Eigen::VectorXd(own_directions_ * rest.transpose()));
    return mean_ + score.transpose() * all_.directions;
  }

 private:
  const Distribution& all_;
  const std::vector<Eigen::Index>& own_;
  /// Of the other shapes, along the axes.
  Eigen::RowVectorXd mean_;
  Eigen::MatrixXd covariance_;
  Eigen::MatrixXd own_directions_;
  Eigen::PartialPivLU<Eigen::MatrixXd> solver_;
};

PointColumns columns_of(const Eigen::RowVectorXd& coordinates) {
  return Eigen::Map<const PointColumns>(coordinates.data(), 3, coordinates.size() / 3);
}

/// The points that a shape has, in the coordinates of its file.
PointColumns own_points(const CorrespondingPoints& shapes, Eigen::Index i) {
  PointColumns points(3, std::ranges::count(shapes.present[i], true));
  Eigen::Index k = 0;
  for (std::size_t p = 0; p < shapes.points[i].size(); ++p)
    if (shapes.present[i][p]) points.col(k++) = shapes.points[i][p];
  return points;
}

void complete_shape(const CorrespondingPoints& shapes, Eigen::Index i, bool keep_size,
                    const Distribution& all, AlignedShapes& aligned) {
  // Where a shape lies and how it goes on depend on each other; where little of it is there, much.
  constexpr int kSteps = 3;
  const std::vector<Eigen::Index> own = own_coordinates(shapes.present[i]);
  const PointColumns points = own_points(shapes, i);
  Eigen::RowVectorXd row = aligned.rows.row(i);
  const Predictor predictor(all, row, i, own);
  Eigen::RowVectorXd given;
  for (int step = 0; step < kSteps; ++step) {
    const Similarity fit = fitted_similarity(points, columns_of(row(own)), keep_size);
    const PointColumns moved = ((fit.scale * fit.rotation) * points).colwise() + fit.translation;
    given = Eigen::Map<const Eigen::RowVectorXd>(moved.data(), moved.size());
    row = predictor.predict(given);
    aligned.alignments[i] = fit;
  }
  row(own) = given;
  aligned.rows.row(i) = row;
}

}  // namespace

void complete_shapes(const CorrespondingPoints& shapes, bool keep_size, AlignedShapes& aligned) {
  constexpr int kMostRounds = 40;
  // They cost their square, and no more have been needed.
  constexpr Eigen::Index kMostAxes = 30;
  // Of the size of the mean, which shapes differ from by far more.
  constexpr double kSettled = 1e-5;
  const ShapeRows known = known_coordinates(shapes);
  Eigen::Index most = 1;
  for (int round = 0; round < kMostRounds; ++round) {
    const ShapeRows before = aligned.rows;
    const Distribution all = distribution_of(before, known, most);
    for (Eigen::Index i = 0; i < before.rows(); ++i)
      if (!std::ranges::all_of(shapes.present[i], std::identity()))
        complete_shape(shapes, i, keep_size, all, aligned);
    align_to_mean(aligned, keep_size);
    const double change = (aligned.rows - before).rowwise().norm().maxCoeff();
    // One after the other, as what is filled in along the first ones shows where the next one is.
    if (all.directions.rows() == most && most < kMostAxes)
      ++most;
    else if (change <= kSettled * all.mean.norm())
      return;
  }
}

}  // namespace isomatch
