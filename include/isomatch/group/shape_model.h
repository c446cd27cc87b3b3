// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/mesh/mesh.h"

/// Statistics of shapes whose points correspond.
namespace isomatch {

/// Points of N shapes that correspond: `points[i][p]` is point p of shape i, in the coordinates of
/// its file. Points that a shape does not have are false in `present[i]`, and whatever stands in
/// their place is not looked at; all are there if `present` is empty.
struct CorrespondingPoints {
  std::vector<std::vector<Point>> points;
  std::vector<std::vector<bool>> present;

  bool has(std::size_t shape, std::size_t point) const {
    return present.empty() || present[shape][point];
  }
};

struct ShapeModelOptions {
  /// Whether size is a part of shape: then shapes are moved and turned but not scaled.
  bool keep_size = false;
  /// Principal modes at most; N - 1 if negative.
  int modes = -1;
};

/// Leads x to scale * rotation * x + translation.
struct Similarity {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Point translation{0, 0, 0};

  Point apply(const Point& x) const { return scale * (rotation * x) + translation; }
  Point undo(const Point& y) const { return rotation.transpose() * (y - translation) / scale; }
};

/// A point distribution model (Cootes et al. 1995): shapes after generalised Procrustes alignment
/// (Gower 1975), their mean and principal modes.
struct ShapeModel {
  /// Around the origin, turned about as the first of the shapes with the most points. Unless size
  /// is kept, its centroid size (root of the sum of squared distances from the centroid) is the
  /// mean of those of the shapes, so that units are those of the files.
  std::vector<Point> mean;
  /// The shapes aligned, N x 3P, x y z of each point in turn, all around the origin and, unless
  /// size is kept, all of one centroid size. Points that a shape lacks are those that a model of
  /// the other shapes predicts from the points that it has.
  Eigen::MatrixXd aligned;
  /// Of each shape from the coordinates of its file to `aligned`; never a reflection.
  std::vector<Similarity> alignments;
  /// Orthonormal rows, K x 3P, largest variance first; the largest entry of each is positive. Modes
  /// without variance, below 1e-10 of the largest or 1e-20 of the mean's squared centroid size, are
  /// left out: K may be 0.
  Eigen::MatrixXd modes;
  /// Of the shapes along each mode (N - 1 in the denominator), in squared units of the mean, summed
  /// over the points.
  Eigen::VectorXd variances;
  /// Of each shape along each mode, N x K, in units of the mean: `aligned` is the mean plus
  /// `scores` times `modes`, if no mode is left out.
  Eigen::MatrixXd scores;

  /// The shape at so many standard deviations along each of the first modes. Throws `InvalidInput`
  /// if these are more than there are modes.
  std::vector<Point> shape_at(const std::vector<double>& deviations) const;
};

/// What tells whether the points of a model correspond well (Davies et al. 2002), for 1, 2, ... K
/// modes. Distances of shapes are root mean squares of those of their points, in units of the mean.
struct ModelQuality {
  /// Share of the total variance.
  std::vector<double> compactness;
  /// Mean distance of a shape that was left out from what a model of the others, aligned as they
  /// are, makes of it; NaN of fewer than three shapes.
  std::vector<double> generalisation;
  /// Mean distance of random shapes of the model, normally distributed, from the nearest shape.
  std::vector<double> specificity;
};

/// Missing points are filled in and the model is fitted again until that settles, 40 times at
/// most. Throws `InvalidInput` if there are fewer than two shapes or three points, if numbers of
/// points differ, if one is not finite or one that no shape has, or if a shape has fewer than
/// three, three that lie apart, or three that are known from others as well. O(N^2 P), each time
/// that points are filled in.
ShapeModel shape_model(const CorrespondingPoints& shapes, const ShapeModelOptions& options = {});

/// Deterministic for a seed. Throws `InvalidInput` if there are no samples.
/// O(N^2 (P + K) + N K samples).
ModelQuality model_quality(const ShapeModel& model, int samples = 1000, unsigned seed = 0);

/// The points of a shape in the coordinates of its file, those that it lacks as the model has them.
std::vector<Point> completed_points(const CorrespondingPoints& shapes, const ShapeModel& model,
                                    int shape);

}  // namespace isomatch
