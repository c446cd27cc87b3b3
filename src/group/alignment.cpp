// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/alignment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/rotation.h"
#include "isomatch/error.h"

namespace isomatch {
namespace {

/// `second` after `first`.
Similarity in_turn(const Similarity& first, const Similarity& second) {
  return {second.scale * first.scale, second.rotation * first.rotation,
          second.apply(first.translation)};
}

void move_shape(AlignedShapes& shapes, Eigen::Index i, const Similarity& similarity) {
  Eigen::Map<PointColumns> points = points_of_row(shapes.rows, i);
  points = ((similarity.scale * similarity.rotation) * points).colwise() + similarity.translation;
  shapes.alignments[i] = in_turn(shapes.alignments[i], similarity);
}

/// To the origin, and to centroid size 1 unless `keep_size`.
void standardise(AlignedShapes& shapes, Eigen::Index i, bool keep_size) {
  const Eigen::Map<PointColumns> points = points_of_row(shapes.rows, i);
  const Point centroid = points.rowwise().mean();
  const double size = keep_size ? 1 : (points.colwise() - centroid).norm();
  move_shape(shapes, i, {1 / size, Eigen::Matrix3d::Identity(), -centroid / size});
}

/// Shapes are added to the mean one by one.
class GrowingMean {
 public:
  GrowingMean(const CorrespondingPoints& shapes, bool keep_size)
      : shapes_(shapes),
        keep_size_(keep_size),
        num_points_(static_cast<int>(shapes.points.front().size())),
        sums_(PointColumns::Zero(3, num_points_)),
        counts_(num_points_),
        shared_(shapes.points.size()),
        alignments_(shapes.points.size()) {}

  AlignedShapes align_all() {
    std::vector<int> waiting(shapes_.points.size());
    std::iota(waiting.begin(), waiting.end(), 0);
    const auto first =
        std::ranges::max_element(waiting, {}, [&](int i) { return known_points(i); });
    add(*first, first_place(*first));
    waiting.erase(first);
    while (!waiting.empty()) {
      const auto next = std::ranges::max_element(waiting, {}, [&](int i) { return shared_[i]; });
      add(*next, place_of(*next));
      waiting.erase(next);
    }
    return filled_in();
  }

 private:
  int known_points(int i) const {
    if (shapes_.present.empty()) return num_points_;
    return static_cast<int>(std::ranges::count(shapes_.present[i], true));
  }

  Similarity first_place(int i) const {
    PointColumns own(3, known_points(i));
    for (int p = 0, k = 0; p < num_points_; ++p)
      if (shapes_.has(i, p)) own.col(k++) = shapes_.points[i][p];
    const Point centroid = own.rowwise().mean();
    const double size = (own.colwise() - centroid).norm();
    if (!(size > 0)) throw InvalidInput(fmt::format("the points of shape {} are at one place", i));
    return {keep_size_ ? 1 : 1 / size, Eigen::Matrix3d::Identity(),
            keep_size_ ? -centroid : Point(-centroid / size)};
  }

  /// By the points that it shares with those before.
  Similarity place_of(int i) const {
    constexpr int kFewest = 3;
    if (shared_[i] < kFewest)
      throw InvalidInput(
          fmt::format("shape {} has fewer than three points in common with the others", i));
    PointColumns own(3, shared_[i]), mean(3, shared_[i]);
    for (int p = 0, k = 0; p < num_points_; ++p) {
      if (counts_[p] == 0 || !shapes_.has(i, p)) continue;
      own.col(k) = shapes_.points[i][p];
      mean.col(k++) = sums_.col(p) / counts_[p];
    }
    try {
      return fitted_similarity(own, mean, keep_size_);
    } catch (const InvalidInput&) {
      throw InvalidInput(
          fmt::format("points of shape {} that others have as well are at one place", i));
    }
  }

  void add(int i, const Similarity& place) {
    alignments_[i] = place;
    for (int p = 0; p < num_points_; ++p) {
      if (!shapes_.has(i, p)) continue;
      sums_.col(p) += place.apply(shapes_.points[i][p]);
      if (counts_[p]++ > 0) continue;
      for (std::size_t j = 0; j < shared_.size(); ++j) shared_[j] += shapes_.has(j, p) ? 1 : 0;
    }
  }

  AlignedShapes filled_in() const {
    const Eigen::Index num_shapes = std::ssize(shapes_.points);
    AlignedShapes aligned{ShapeRows(num_shapes, 3 * num_points_), alignments_};
    for (Eigen::Index i = 0; i < num_shapes; ++i) {
      Eigen::Map<PointColumns> points = points_of_row(aligned.rows, i);
      for (int p = 0; p < num_points_; ++p)
        points.col(p) = shapes_.has(i, p) ? alignments_[i].apply(shapes_.points[i][p])
                                          : Point(sums_.col(p) / counts_[p]);
    }
    return aligned;
  }

  const CorrespondingPoints& shapes_;
  bool keep_size_;
  int num_points_;
  PointColumns sums_;
  /// Of each point, how many shapes that were added have it.
  std::vector<int> counts_;
  /// Of each shape, how many of its points have been added.
  std::vector<int> shared_;
  std::vector<Similarity> alignments_;
};

}  // namespace

Similarity fitted_similarity(const PointColumns& from, const PointColumns& to, bool keep_size) {
  const Point from_centroid = from.rowwise().mean(), to_centroid = to.rowwise().mean();
  const PointColumns a = from.colwise() - from_centroid, b = to.colwise() - to_centroid;
  Similarity similarity;
  similarity.rotation = best_rotation(b * a.transpose());
  const double from_size = a.norm(), to_size = b.norm();
  if (!keep_size) {
    if (!(from_size > 0 && to_size > 0)) throw InvalidInput("points are at one place");
    similarity.scale = to_size / from_size;
  }
  similarity.translation = to_centroid - similarity.scale * (similarity.rotation * from_centroid);
  return similarity;
}

AlignedShapes first_alignment(const CorrespondingPoints& shapes, bool keep_size) {
  return GrowingMean(shapes, keep_size).align_all();
}

void align_to_mean(AlignedShapes& shapes, bool keep_size) {
  // What is left changes the mean by the square of how much shapes differ, each time.
  constexpr int kMostRounds = 100;
  constexpr double kSettled = 1e-12;
  const Eigen::Index num_shapes = shapes.rows.rows();
  for (Eigen::Index i = 0; i < num_shapes; ++i) standardise(shapes, i, keep_size);
  Eigen::RowVectorXd mean = shapes.rows.colwise().mean();
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::Map<const PointColumns> to(mean.data(), 3, mean.size() / 3);
    for (Eigen::Index i = 0; i < num_shapes; ++i) {
      const Eigen::Matrix3d covariance = to * points_of_row(shapes.rows, i).transpose();
      move_shape(shapes, i, {1, best_rotation(covariance), Point::Zero()});
    }
    const Eigen::RowVectorXd before = mean;
    mean = shapes.rows.colwise().mean();
    if ((mean - before).norm() <= kSettled * before.norm()) return;
  }
}

void restore_size(AlignedShapes& shapes) {
  double mean_size = 0;
  for (const Similarity& alignment : shapes.alignments)
    mean_size += 1 / alignment.scale / static_cast<double>(shapes.alignments.size());
  const double factor = mean_size / shapes.rows.colwise().mean().norm();
  shapes.rows *= factor;
  for (Similarity& alignment : shapes.alignments) {
    alignment.scale *= factor;
    alignment.translation *= factor;
  }
}

}  // namespace isomatch
