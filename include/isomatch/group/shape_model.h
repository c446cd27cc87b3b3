// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/mesh/mesh.h"

/// Statistics of shapes whose points correspond.
namespace isomatch {

/// Points of N shapes that correspond: `points[i][p]` is point p of shape i, in the coordinates of
/// its file. Points that a shape does not have are false in `present[i]`; all are there if it is
/// empty.
struct CorrespondingPoints {
  std::vector<std::vector<Point>> points;
  std::vector<std::vector<bool>> present;
};

struct ShapeModelOptions {
  /// Whether size is a part of shape: then shapes are moved and turned but not scaled.
  bool keep_size = false;
  /// Principal modes at most; N - 1 if negative.
  int modes = -1;
};

/// A point distribution model (Cootes et al. 1995): shapes after generalised Procrustes alignment
/// (Gower 1975), their mean and principal modes.
struct ShapeModel {
  std::vector<Point> mean;
  /// The shapes aligned, N x 3P, x y z of each point in turn; points that were missing are those
  /// that the model predicts from the others.
  Eigen::MatrixXd aligned;
  /// Orthonormal rows, K x 3P, largest variance first; the largest entry of each is positive.
  Eigen::MatrixXd modes;
  /// Of the shapes along each mode (N - 1 in the denominator), in squared units of the mean.
  Eigen::VectorXd variances;
  /// Of each shape along each mode, N x K, in units of the mean.
  Eigen::MatrixXd scores;

  /// The shape at so many standard deviations along each of the first modes.
  std::vector<Point> shape_at(const std::vector<double>& deviations) const;
};

/// What tells whether the points of a model correspond well (Davies et al. 2002), for 1, 2, ... K
/// modes.
struct ModelQuality {
  /// Share of the total variance.
  std::vector<double> compactness;
  /// Mean distance of the points of a shape that was left out from what a model of the others makes
  /// of it, in units of the mean; NaN of fewer than three shapes.
  std::vector<double> generalisation;
  /// Mean distance of the points of random shapes of the model from those of the nearest shape.
  std::vector<double> specificity;
};

/// Throws `InvalidInput` if there are fewer than two shapes or three points, if numbers of points
/// differ, if one is not finite, or if a shape has fewer than three. O(N^2 P).
ShapeModel shape_model(const CorrespondingPoints& shapes, const ShapeModelOptions& options = {});

/// Deterministic for a seed. O(N^2 P K).
ModelQuality model_quality(const ShapeModel& model, int samples = 1000, unsigned seed = 0);

}  // namespace isomatch
