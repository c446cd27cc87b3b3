// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/group/shape_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "group/alignment.h"
#include "group/completion.h"
#include "group/principal_axes.h"
#include "isomatch/error.h"

namespace isomatch {
namespace {

constexpr std::size_t kFewestPoints = 3;

void check_lengths(const CorrespondingPoints& shapes) {
  if (shapes.points.size() < 2) throw InvalidInput("a model needs two shapes");
  const std::size_t num_points = shapes.points.front().size();
  if (num_points < kFewestPoints) throw InvalidInput("a model needs three points");
  const auto differs = [&](const auto& list) { return list.size() != num_points; };
  if (std::ranges::any_of(shapes.points, differs))
    throw InvalidInput("the shapes of a model must have the same number of points");
  if (!shapes.present.empty() && (shapes.present.size() != shapes.points.size() ||
                                  std::ranges::any_of(shapes.present, differs)))
    throw InvalidInput("which points are present must be said of each or of none");
}

void check_points(const CorrespondingPoints& shapes) {
  std::vector<bool> is_known(shapes.points.front().size());
  for (std::size_t i = 0; i < shapes.points.size(); ++i) {
    std::size_t count = 0;
    for (std::size_t p = 0; p < is_known.size(); ++p) {
      if (!shapes.has(i, p)) continue;
      ++count;
      is_known[p] = true;
      if (!shapes.points[i][p].allFinite())
        throw InvalidInput(fmt::format("point {} of shape {} is not finite", p, i));
    }
    if (count < kFewestPoints)
      throw InvalidInput(fmt::format("shape {} has fewer than three points", i));
  }
  const auto unknown = std::ranges::find(is_known, false);
  if (unknown != is_known.end())
    throw InvalidInput(fmt::format("no shape has point {}", unknown - is_known.begin()));
}

bool is_complete(const CorrespondingPoints& shapes) {
  return std::ranges::all_of(shapes.present, [](const std::vector<bool>& present) {
    return std::ranges::all_of(present, std::identity());
  });
}

AlignedShapes aligned_shapes(const CorrespondingPoints& shapes, bool keep_size) {
  AlignedShapes aligned = first_alignment(shapes, keep_size);
  align_to_mean(aligned, keep_size);
  if (!is_complete(shapes)) complete_shapes(shapes, keep_size, aligned);
  if (!keep_size) restore_size(aligned);
  return aligned;
}

/// Turns axes so that the largest entry of each is positive: the first of those that are equal but
/// for rounding, of which symmetric shapes have many.
void fix_signs(Eigen::MatrixXd& directions, Eigen::MatrixXd& scores) {
  constexpr double kEqual = 1 - 1e-6;
  for (Eigen::Index k = 0; k < directions.rows(); ++k) {
    const double largest = directions.row(k).cwiseAbs().maxCoeff();
    Eigen::Index at = 0;
    while (std::abs(directions(k, at)) < kEqual * largest) ++at;
    if (directions(k, at) > 0) continue;
    directions.row(k) *= -1;
    scores.col(k) *= -1;
  }
}

std::vector<Point> listed_points(const Eigen::RowVectorXd& coordinates) {
  std::vector<Point> points;
  points.reserve(coordinates.size() / 3);
  for (Eigen::Index k = 0; k < coordinates.size(); k += 3)
    points.emplace_back(coordinates.segment<3>(k));
  return points;
}

}  // namespace

ShapeModel shape_model(const CorrespondingPoints& shapes, const ShapeModelOptions& options) {
  check_lengths(shapes);
  check_points(shapes);
  AlignedShapes aligned = aligned_shapes(shapes, options.keep_size);
  const Eigen::RowVectorXd mean = aligned.rows.colwise().mean();
  const ShapeRows deviations = deviations_from(mean, aligned.rows);
  const PrincipalAxes axes = principal_axes(deviations, least_variance(mean));
  const Eigen::Index all = axes.variances.size();
  const Eigen::Index count = options.modes < 0 ? all : std::min<Eigen::Index>(options.modes, all);
  ShapeModel model;
  model.mean = listed_points(mean);
  model.aligned = aligned.rows;
  model.alignments = std::move(aligned.alignments);
  model.modes = axis_directions(deviations, axes, count);
  model.variances = axes.variances.head(count);
  model.scores = axes.scores.leftCols(count);
  fix_signs(model.modes, model.scores);
  return model;
}

std::vector<Point> ShapeModel::shape_at(const std::vector<double>& deviations) const {
  if (std::ssize(deviations) > modes.rows())
    throw InvalidInput(
        fmt::format("there are no {} modes but {}", deviations.size(), modes.rows()));
  std::vector<Point> shape = mean;
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const double length = deviations[k] * std::sqrt(variances[row]);
    for (std::size_t p = 0; p < shape.size(); ++p)
      shape[p] += length * modes.row(row).segment<3>(static_cast<Eigen::Index>(3 * p)).transpose();
  }
  return shape;
}

std::vector<Point> completed_points(const CorrespondingPoints& shapes, const ShapeModel& model,
                                    int shape) {
  std::vector<Point> points = shapes.points[shape];
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (shapes.has(shape, p)) continue;
    const auto at = static_cast<Eigen::Index>(3 * p);
    points[p] = model.alignments[shape].undo(model.aligned.row(shape).segment<3>(at).transpose());
  }
  return points;
}

}  // namespace isomatch
