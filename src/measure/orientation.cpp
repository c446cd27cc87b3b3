// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/hat_gradients.h"
#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "measure/spread_matches.h"
#include "parallel.h"
#include "shape/prepared_shape.h"

namespace isomatch {
namespace {

/// A landmark's image may be this much nearer or farther than the landmark itself: maps stretch and
/// are noisy, but a collapsed one has no orientation.
constexpr double kMaxStretch = 2.5;
/// A verdict needs so many votes and this share of them. Right maps of the shapes tried have .8
/// to 1.
constexpr int kMinVotes = 8;
constexpr double kMinShare = 0.6;

/// At each landmark the directions towards the others that are neither too near nor too far.
class DirectionTable {
 public:
  DirectionTable(const MetricSurface& shape, const std::vector<int>& landmarks, double min_distance,
                 double max_distance, const Context& context);

  bool known(int at, int towards) const { return !direction(at, towards).isZero(); }
  /// Sine of the angle from the direction towards `a` to that towards `b`, counter-clockwise seen
  /// from outside.
  double sine(int at, int a, int b) const {
    return normals_[at].dot(direction(at, a).cross(direction(at, b)));
  }

 private:
  const Point& direction(int at, int towards) const {
    return directions_[static_cast<std::size_t>(at) * normals_.size() + towards];
  }
  Point gradient(int vertex, std::span<const float> field) const;
  void look_towards(int landmark, std::span<const float> field);

  const MetricSurface& shape_;
  const std::vector<int>& landmarks_;
  double min_distance_, max_distance_;
  std::vector<Point> normals_;
  std::vector<Point> directions_;
};

DirectionTable::DirectionTable(const MetricSurface& shape, const std::vector<int>& landmarks,
                               double min_distance, double max_distance, const Context& context)
    : shape_(shape),
      landmarks_(landmarks),
      min_distance_(min_distance),
      max_distance_(max_distance),
      directions_(landmarks.size() * landmarks.size(), Point(0, 0, 0)) {
  for (int v : landmarks) normals_.push_back(shape.surface().normals[v]);
  struct Work {
    GeodesicSearch search;
    std::vector<float> field;
  };
  const auto make = [&] {
    return Work{GeodesicSearch(shape.graph()), std::vector<float>(shape.num_vertices())};
  };
  parallel_for(std::ssize(landmarks), context, make, [&](Work& work, std::ptrdiff_t j) {
    work.search.field(landmarks[j], work.field);
    look_towards(static_cast<int>(j), work.field);
  });
}

Point DirectionTable::gradient(int vertex, std::span<const float> field) const {
  const Mesh& mesh = shape_.mesh();
  Point sum(0, 0, 0);
  for (int f : shape_.surface().faces[vertex]) {
    const std::array<Point, 3> gradients = hat_gradients(mesh, mesh.faces[f]);
    for (int k = 0; k < 3; ++k) sum += field[mesh.faces[f][k]] * gradients[k];
  }
  return sum;
}

void DirectionTable::look_towards(int landmark, std::span<const float> field) {
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const float distance = field[landmarks_[i]];
    if (distance < min_distance_ || distance > max_distance_) continue;
    const Point uphill = gradient(landmarks_[i], field);
    const Point tangent = uphill - uphill.dot(normals_[i]) * normals_[i];
    directions_[i * normals_.size() + landmark] = -tangent.normalized();
  }
}

/// What one landmark sees: the sum over all pairs of others of the product of the sines on both
/// shapes, and of its magnitude. Nearly collinear pairs weigh little, since noise turns them over.
struct Vote {
  double sum = 0;
  double weight = 0;
};

Vote vote(const DirectionTable& source, const DirectionTable& target, int at, int landmarks) {
  std::vector<int> seen;
  for (int j = 0; j < landmarks; ++j) {
    if (source.known(at, j) && target.known(at, j)) seen.push_back(j);
  }
  Vote result;
  for (std::size_t a = 0; a < seen.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double product = source.sine(at, seen[a], seen[b]) * target.sine(at, seen[a], seen[b]);
      result.sum += product;
      result.weight += std::abs(product);
    }
  }
  return result;
}

OrientationVerdict verdict(const MapOrientation& orientation) {
  if (orientation.votes < kMinVotes) return OrientationVerdict::kUndecided;
  if (orientation.preserved_share >= kMinShare) return OrientationVerdict::kPreserves;
  if (orientation.preserved_share <= 1 - kMinShare) return OrientationVerdict::kReverses;
  return OrientationVerdict::kUndecided;
}

MapOrientation count_votes(const DirectionTable& source, const DirectionTable& target,
                           int landmarks) {
  MapOrientation result;
  Vote all;
  int preserving = 0;
  for (int i = 0; i < landmarks; ++i) {
    const auto [sum, weight] = vote(source, target, i, landmarks);
    if (weight == 0) continue;
    all.sum += sum;
    all.weight += weight;
    ++result.votes;
    preserving += sum > 0;
  }
  if (result.votes == 0) return result;
  result.preserved_share = static_cast<double>(preserving) / result.votes;
  result.mean_sign = all.sum / all.weight;
  result.verdict = verdict(result);
  return result;
}

}  // namespace

std::string_view to_string(OrientationVerdict verdict) {
  switch (verdict) {
    case OrientationVerdict::kPreserves:
      return "preserves";
    case OrientationVerdict::kReverses:
      return "reverses";
    case OrientationVerdict::kUndecided:
      return "undecided";
    case OrientationVerdict::kNotOriented:
      return "not oriented";
  }
  throw InternalError("unknown orientation verdict");
}

void OrientationOptions::validate() const {
  if (landmarks < 3) throw InvalidInput("landmarks must be at least 3");
  if (!(min_distance > 0 && min_distance < max_distance))
    throw InvalidInput("min_distance must be positive and less than max_distance");
}

MapOrientation map_orientation(const Shape& source, const Shape& target,
                               const Correspondence& matches, const OrientationOptions& options,
                               const Context& context) {
  options.validate();
  const SurfaceMatches between =
      on_surfaces(*source.prepared().surface(), *target.prepared().surface(), matches);
  const MetricSurface from = source.prepared().metric(context);
  const MetricSurface onto = target.prepared().metric(context);
  if (!from.surface().oriented || !onto.surface().oriented)
    return {.verdict = OrientationVerdict::kNotOriented};
  std::vector<int> sources, targets;
  for (const Match& match : evenly_spaced_matches(from, between, options.landmarks)) {
    sources.push_back(match.source);
    targets.push_back(match.target);
  }
  const DirectionTable seen_on_source(from, sources, options.min_distance, options.max_distance,
                                      context);
  const DirectionTable seen_on_target(onto, targets, options.min_distance / kMaxStretch,
                                      options.max_distance * kMaxStretch, context);
  return count_votes(seen_on_source, seen_on_target, static_cast<int>(sources.size()));
}

}  // namespace isomatch
