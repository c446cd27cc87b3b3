// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/group/shape_model.h"

namespace isomatch {

/// A shape a row, x y z of each point in turn.
using ShapeRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using PointColumns = Eigen::Matrix3Xd;

/// The points of a row as columns.
inline Eigen::Map<PointColumns> points_of_row(ShapeRows& rows, Eigen::Index shape) {
  return {rows.row(shape).data(), 3, rows.cols() / 3};
}

/// Shapes in a common frame.
struct AlignedShapes {
  /// What a shape lacks is filled in.
  ShapeRows rows;
  /// From the coordinates of the files.
  std::vector<Similarity> alignments;
};

/// The similarity that leads points `from` to `to`, of the same number: the best rotation (Kabsch
/// 1976) between the centroids; the ratio of the centroid sizes, 1 if `keep_size`, which, other
/// than the best, does not shrink what does not fit. Throws `InvalidInput` if points that determine
/// the size are at one place.
Similarity fitted_similarity(const PointColumns& from, const PointColumns& to, bool keep_size);

/// Aligns shapes one by one to the mean of those before, the one that has the most points in common
/// with them next, and gives them the points that they lack from the mean.
AlignedShapes first_alignment(const CorrespondingPoints& shapes, bool keep_size);

/// Generalised Procrustes alignment (Gower 1975): moves all shapes to the origin, scales them to
/// centroid size 1 unless `keep_size`, and turns them to their mean until that settles.
void align_to_mean(AlignedShapes& shapes, bool keep_size);

/// Scales all by one factor: the mean gets the mean centroid size that shapes have in their files.
void restore_size(AlignedShapes& shapes);

}  // namespace isomatch
