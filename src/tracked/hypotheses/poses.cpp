// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/poses.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "geometry/kd_tree.h"
#include "geometry/rotation.h"

namespace isomatch::tracked {
namespace {

/// Points of a surface with normals that do not depend on its details.
struct OrientedPoints {
  std::vector<Point> positions, normals;
  std::vector<double> areas;
  /// From the rim, infinite where nothing is missing.
  std::vector<double> to_rim;

  int size() const { return static_cast<int>(positions.size()); }
};

OrientedPoints oriented_points(const Proxy& proxy, int count) {
  const NodeGraph graph = node_graph(proxy, count);
  OrientedPoints points{graph.cloud.positions, graph.cloud.normals, graph.cloud.areas, {}};
  for (int i = 0; i < points.size(); ++i) {
    for (int j : graph.neighbours[i]) points.normals[i] += graph.cloud.normals[j];
    points.normals[i].normalize();
    points.to_rim.push_back(proxy.to_boundary[proxy.nodes[i]]);
  }
  return points;
}

/// What two points with normals have in common with those that a rigid motion makes of them:
/// distance and angles, in units of bins.
using PairFeature = std::array<double, 4>;

double angle(const Point& a, const Point& b) { return std::acos(std::clamp(a.dot(b), -1.0, 1.0)); }

PairFeature feature(const OrientedPoints& points, int i, int j, const PoseOptions& options) {
  const Point between = points.positions[j] - points.positions[i];
  const double length = between.norm();
  const Point direction = between / length;
  const double bin = options.angle_bin;
  return {length / options.length_bin, angle(points.normals[i], direction) / bin,
          angle(points.normals[j], direction) / bin,
          angle(points.normals[i], points.normals[j]) / bin};
}

int key(const std::array<int, 4>& bins) {
  constexpr int kBins = 64;  // More than there are of any.
  return ((bins[0] * kBins + bins[1]) * kBins + bins[2]) * kBins + bins[3];
}

/// Turns the normal at a point to the first axis; the angle about it is left open.
Eigen::Matrix3d upright(const Point& normal) {
  return Eigen::Quaterniond::FromTwoVectors(normal, Point::UnitX()).toRotationMatrix();
}

/// The angle of a point about the normal of another one.
double angle_about(const Eigen::Matrix3d& upright, const Point& offset) {
  const Point p = upright * offset;
  return std::atan2(p.z(), p.y());
}

struct TargetPair {
  int first;
  float angle;
};

/// All pairs of points of the target by their features.
class PairTable {
 public:
  PairTable(const OrientedPoints& points, const PoseOptions& options) : options_(options) {
    for (int i = 0; i < points.size(); ++i) {
      const Eigen::Matrix3d frame = upright(points.normals[i]);
      for (int j = 0; j < points.size(); ++j) {
        const Point offset = points.positions[j] - points.positions[i];
        if (i == j || !in_range(offset.norm())) continue;
        std::array<int, 4> bins{};
        const PairFeature f = feature(points, i, j, options);
        std::ranges::transform(f, bins.begin(), [](double x) { return static_cast<int>(x); });
        pairs_[key(bins)].push_back({i, static_cast<float>(angle_about(frame, offset))});
      }
    }
  }

  bool in_range(double length) const {
    return length >= options_.shortest_pair && length <= options_.longest_pair;
  }

  /// Visits the pairs in the bin of a feature and the nearest others.
  template <class Visit>
  void for_each_like(const PairFeature& f, const Visit& visit) const {
    for (int corner = 0; corner < 16; ++corner) {
      std::array<int, 4> bins{};
      for (int k = 0; k < 4; ++k)
        bins[k] = static_cast<int>(std::floor(f[k] - 0.5)) + ((corner >> k) & 1);
      if (std::ranges::any_of(bins, [](int bin) { return bin < 0; })) continue;
      const auto found = pairs_.find(key(bins));
      if (found != pairs_.end())
        for (const TargetPair& pair : found->second) visit(pair);
    }
  }

 private:
  const PoseOptions& options_;
  std::unordered_map<int, std::vector<TargetPair>> pairs_;
};

/// A surface on which others may lie.
class Ground {
 public:
  struct Nearest {
    int point;
    double distance;
  };

  Ground(const OrientedPoints& points, const PoseOptions& options)
      : points_(points), options_(options), places_(points.positions) {
    for (int i = 0; i < points.size(); ++i)
      coordinates_.push_back(coordinates(points.positions[i], points.normals[i]));
    oriented_.emplace(coordinates_);
  }

  const Point& position(int point) const { return points_.positions[point]; }

  /// The point that lies below another one, if it is close and faces the same way.
  std::optional<Nearest> below(const Point& p, const Point& normal, double radius) const {
    const int point = oriented_->nearest(coordinates(p, normal));
    const double distance = (points_.positions[point] - p).norm();
    if (distance >= radius || points_.normals[point].dot(normal) < options_.min_cosine) return {};
    return Nearest{point, distance};
  }

  /// Whether a point that lies on nothing should lie on something: what is closest to it is not
  /// the rim, beyond which it may be what is missing.
  bool contradicts(const Point& p) const {
    const int point = places_.nearest(p);
    return (points_.positions[point] - p).norm() < options_.contradiction_range &&
           points_.to_rim[point] > options_.rim_width;
  }

 private:
  using Coordinates = KdTree<6>::Coordinates;

  Coordinates coordinates(const Point& position, const Point& normal) const {
    Coordinates result;
    result << position, options_.normal_weight * normal;
    return result;
  }

  const OrientedPoints& points_;
  const PoseOptions& options_;
  KdTree<3> places_;
  std::vector<Coordinates> coordinates_;
  std::optional<KdTree<6>> oriented_;
};

/// How well a source lies on a target under a motion. Both are given twice: a few points that are
/// looked at, and many on which they may lie.
class Fitting {
 public:
  struct Side {
    const OrientedPoints& few;
    const OrientedPoints& many;
  };

  Fitting(const Side& source, const Side& target, const PoseOptions& options)
      : source_(source.few),
        target_(target.few),
        options_(options),
        below_source_(source.many, options),
        below_target_(target.many, options) {}

  /// Only what lies on the target counts.
  void estimate(Pose& pose) const {
    pose.overlap = 0;
    for (int i = 0; i < source_.size(); ++i)
      if (const auto found = below_target(pose, i, options_.close))
        pose.overlap += source_.areas[i] * (1 - found->distance / options_.close);
  }

  /// What contradicts the pose, on both sides, counts against it.
  void measure(Pose& pose) const {
    estimate(pose);
    double against = 0;
    for (int i = 0; i < source_.size(); ++i)
      if (!below_target(pose, i, options_.close) &&
          below_target_.contradicts(pose(source_.positions[i])))
        against += source_.areas[i];
    const Eigen::Matrix3d back = pose.rotation.transpose();
    for (int i = 0; i < target_.size(); ++i) {
      const Point p = back * (target_.positions[i] - pose.shift);
      if (!below_source_.below(p, back * target_.normals[i], options_.close) &&
          below_source_.contradicts(p))
        against += target_.areas[i];
    }
    pose.overlap -= options_.contradiction * against;
  }

  /// Iterated closest points; those that have none nearby do not count.
  void improve(Pose& pose) const {
    for (int step = 0; step < options_.iterations; ++step) {
      const double radius = options_.close * (step < options_.iterations / 2 ? 1.5 : 1);
      std::vector<Point> from, to;
      for (int i = 0; i < source_.size(); ++i) {
        const auto found = below_target(pose, i, radius);
        if (!found) continue;
        from.push_back(source_.positions[i]);
        to.push_back(below_target_.position(found->point));
      }
      if (from.size() < 4) break;
      pose.rotation = best_rotation(from, to);
      pose.shift = mean_of(to) - pose.rotation * mean_of(from);
    }
    measure(pose);
  }

  /// Root mean square distance of what two poses make of the source.
  double difference(const Pose& a, const Pose& b) const {
    double sum = 0, area = 0;
    for (int i = 0; i < source_.size(); ++i) {
      sum += source_.areas[i] * (a(source_.positions[i]) - b(source_.positions[i])).squaredNorm();
      area += source_.areas[i];
    }
    return std::sqrt(sum / area);
  }

 private:
  std::optional<Ground::Nearest> below_target(const Pose& pose, int i, double radius) const {
    return below_target_.below(pose(source_.positions[i]), pose.rotation * source_.normals[i],
                               radius);
  }

  const OrientedPoints& source_;
  const OrientedPoints& target_;
  const PoseOptions& options_;
  Ground below_source_, below_target_;
};

/// The poses that most pairs with one point of the source speak for.
class Voting {
 public:
  Voting(const OrientedPoints& source, const OrientedPoints& target, const PoseOptions& options)
      : source_(source),
        target_(target),
        options_(options),
        table_(target, options),
        turns_(static_cast<int>(std::lround(2 * std::numbers::pi / options.angle_bin))),
        votes_(static_cast<std::size_t>(target.size()) * turns_) {}

  void poses_at(int i, std::vector<Pose>& poses) {
    std::ranges::fill(votes_, 0);
    const Eigen::Matrix3d frame = upright(source_.normals[i]);
    for (int j = 0; j < source_.size(); ++j) {
      const Point offset = source_.positions[j] - source_.positions[i];
      if (i == j || !table_.in_range(offset.norm())) continue;
      const double own = angle_about(frame, offset);
      table_.for_each_like(feature(source_, i, j, options_), [&](const TargetPair& pair) {
        ++votes_[static_cast<std::size_t>(pair.first) * turns_ + turn_of(pair.angle - own)];
      });
    }
    for (int k = 0; k < options_.peaks; ++k) {
      const auto most = std::ranges::max_element(votes_);
      if (*most == 0) return;
      const auto at = static_cast<int>(most - votes_.begin());
      poses.push_back(pose(i, frame, at / turns_, at % turns_));
      *most = 0;
    }
  }

 private:
  int turn_of(double angle) const {
    const double turns = angle / (2 * std::numbers::pi);
    return static_cast<int>((turns - std::floor(turns)) * turns_) % turns_;
  }

  Pose pose(int i, const Eigen::Matrix3d& frame, int target, int turn) const {
    const double angle = (turn + 0.5) * 2 * std::numbers::pi / turns_;
    Pose pose;
    pose.rotation = upright(target_.normals[target]).transpose() *
                    Eigen::AngleAxisd(angle, Point::UnitX()) * frame;
    pose.shift = target_.positions[target] - pose.rotation * source_.positions[i];
    return pose;
  }

  const OrientedPoints& source_;
  const OrientedPoints& target_;
  const PoseOptions& options_;
  PairTable table_;
  int turns_;
  std::vector<int> votes_;
};

/// The most overlap first; of poses that are nearly the same the first, `count` at most.
void select(std::vector<Pose>& poses, const Fitting& fitting, double same, int count) {
  std::ranges::stable_sort(poses, std::greater(), &Pose::overlap);
  std::vector<Pose> kept;
  for (const Pose& pose : poses) {
    if (static_cast<int>(kept.size()) == count) break;
    const bool known = std::ranges::any_of(
        kept, [&](const Pose& other) { return fitting.difference(pose, other) < same; });
    if (!known) kept.push_back(pose);
  }
  poses = std::move(kept);
}

}  // namespace

std::vector<Point> posed(const Pose& pose, std::vector<Point> points) {
  for (Point& p : points) p = pose(p);
  return points;
}

std::vector<Pose> find_poses(const Proxy& source, const Proxy& target, const PoseOptions& options) {
  const OrientedPoints from = oriented_points(source, options.source_points);
  const OrientedPoints onto = oriented_points(target, options.target_points);
  const OrientedPoints fine_from = oriented_points(source, source.num_nodes()),
                       fine_onto = oriented_points(target, target.num_nodes());
  const Fitting fitting({from, fine_from}, {onto, fine_onto}, options);
  Voting voting(from, onto, options);
  std::vector<Pose> poses;
  for (int i = 0; i < from.size(); ++i) voting.poses_at(i, poses);
  for (Pose& pose : poses) fitting.estimate(pose);
  select(poses, fitting, options.same, options.improved);
  for (Pose& pose : poses) fitting.improve(pose);
  select(poses, fitting, options.same, options.kept);
  return poses;
}

Correspondence matches_under(const Pose& pose, const Proxy& source, const NodeDirections& from,
                             const Proxy& target, const NodeDirections& onto,
                             const PoseOptions& options) {
  Correspondence matches;
  for (int i = 0; i < from.size(); ++i) {
    const Point p = pose(source.node_position(from.node(i)));
    const Point normal = pose.rotation * source.node_normal(from.node(i));
    int best = kUnmatched;
    double least = options.close;
    for (int t = 0; t < onto.size(); ++t) {
      const double distance = (target.node_position(onto.node(t)) - p).norm();
      if (distance >= least || target.node_normal(onto.node(t)).dot(normal) < options.min_cosine)
        continue;
      least = distance;
      best = t;
    }
    if (best != kUnmatched) matches.push_back({i, best});
  }
  return matches;
}

}  // namespace isomatch::tracked
