// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nanoflann.hpp>
#include <vector>

namespace isomatch {

/// A k-d tree over points of `Dimension` coordinates, to which it keeps a reference. Of points that
/// are equally near the lower index counts. Building costs O(N log N), a search O(log N) as a rule.
/// Searches may run in parallel.
template <int Dimension>
class KdTree {
 public:
  using Coordinates = Eigen::Matrix<double, Dimension, 1>;

  explicit KdTree(const std::vector<Coordinates>& points)
      : points_(points),
        index_(Dimension, *this, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafPoints)) {}

  /// Index of the nearest point; 0 if there is none, because `query` is not finite.
  int nearest(const Coordinates& query) const { return nearest(query, -1); }

  /// The same, found sooner if point `guess` is near; any if it is negative.
  int nearest(const Coordinates& query, int guess) const {
    std::array<int, 1> found{};
    NearestSet<1> set(found);
    if (guess >= 0) set.addPoint((query - points_[guess]).squaredNorm(), guess);
    index_.findNeighbors(set, query.data(), {});
    return found[0];
  }

  /// Indices of the K nearest points, nearest first; returns how many there are.
  template <std::size_t K>
  std::size_t nearest(const Coordinates& query, std::array<int, K>& indices) const {
    NearestSet<K> found(indices);
    index_.findNeighbors(found, query.data(), {});
    return found.size();
  }

  // What nanoflann asks for.
  std::size_t kdtree_get_point_count() const { return points_.size(); }
  double kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return points_[index][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

 private:
  /// nanoflann's own set keeps whichever of equally near points it meets first.
  template <std::size_t K>
  class NearestSet {
   public:
    using DistanceType = double;

    explicit NearestSet(std::array<int, K>& indices) : indices_(indices) {}

    std::size_t size() const { return size_; }
    bool full() const { return size_ == K; }
    /// Only what is less is offered: a little more, for the sake of ties.
    double worstDist() const { return bound_; }  // NOLINT(readability-identifier-naming)
    bool addPoint(double distance, int index) {  // NOLINT(readability-identifier-naming)
      std::size_t at = size_;
      for (; at > 0 && is_before(distance, index, at - 1); --at) {
        if (at == K) continue;
        distances_[at] = distances_[at - 1];
        indices_[at] = indices_[at - 1];
      }
      if (at == K) return true;
      distances_[at] = distance;
      indices_[at] = index;
      size_ += full() ? 0 : 1;
      if (full()) bound_ = std::nextafter(distances_[K - 1], kInfinity);
      return true;
    }

   private:
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();

    bool is_before(double distance, int index, std::size_t other) const {
      return distance < distances_[other] ||
             (distance == distances_[other] && index < indices_[other]);
    }

    std::array<int, K>& indices_;
    std::array<double, K> distances_;
    std::size_t size_ = 0;
    double bound_ = kInfinity;
  };

  /// More than nanoflann's ten: looking at a point takes less time than going to another leaf.
  static constexpr std::size_t kLeafPoints = 24;

  /// nanoflann's own adds the coordinates one by one.
  struct Metric {
    using ElementType = double;   // NOLINT(readability-identifier-naming)
    using DistanceType = double;  // NOLINT(readability-identifier-naming)

    const KdTree& tree;

    explicit Metric(const KdTree& t) : tree(t) {}
    // NOLINTNEXTLINE(readability-identifier-naming)
    double evalMetric(const double* query, std::uint32_t index, std::size_t) const {
      return (Eigen::Map<const Coordinates>(query) - tree.points_[index]).squaredNorm();
    }
    // NOLINTNEXTLINE(readability-identifier-naming)
    double accum_dist(double a, double b, std::size_t) const { return (a - b) * (a - b); }
  };

  const std::vector<Coordinates>& points_;
  nanoflann::KDTreeSingleIndexAdaptor<Metric, KdTree, Dimension, int> index_;
};

}  // namespace isomatch
