// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/closest_point.h"
#include "geometry/interpolation.h"
#include "geometry/kd_tree.h"
#include "geometry/weld.h"
#include "isomatch/carry/map_inversion.h"
#include "isomatch/error.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"
#include "isomatch/shape/diagnosis.h"
#include "parallel.h"

namespace isomatch {
namespace {

/// Normals of vertices, those of split ones equal; zero where they cancel out.
std::vector<Point> vertex_normals(const Mesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  const std::vector<Point> sums = weighted_vertex_normals(welded.mesh);
  std::vector<Point> normals;
  normals.reserve(mesh.vertices.size());
  for (int v : welded.vertex) normals.push_back(sums[v].normalized());
  return normals;
}

/// The images of source vertices on the target, in a space of position and weighted normal.
class Images {
 public:
  using Coordinates = KdTree<6>::Coordinates;

  Images(const Mesh& source, const Mesh& target, const SurfaceMap& source_to_target,
         double normal_weight)
      : normal_weight_(normal_weight), normals_(vertex_normals(target)) {
    std::vector<int> image_of(source.vertices.size(), kNoVertex);
    for (int v = 0; v < source.num_vertices(); ++v) {
      const SurfacePoint& point = source_to_target[v];
      if (point.face == kNoFace) continue;
      image_of[v] = static_cast<int>(points_.size());
      points_.push_back(image(target, point));
    }
    for (int f = 0; f < source.num_faces(); ++f) {
      Face face;
      for (int k = 0; k < 3; ++k) face[k] = image_of[source.faces[f][k]];
      if (std::ranges::count(face, kNoVertex) > 0) continue;
      faces_.faces.push_back(face);
      source_face_.push_back(f);
    }
    faces_.vertices.resize(points_.size());
    around_ = vertex_faces(faces_);
    tree_.emplace(points_);
  }

  bool empty() const { return faces_.faces.empty(); }

  Coordinates coordinates(const Mesh& target, int vertex) const {
    return joined(target.vertices[vertex], normals_[vertex]);
  }

  /// The source point whose image is closest to `query` in position and normal, on the faces around
  /// the nearest images; none if it is farther than `max_distance` in position.
  SurfacePoint nearest(const Coordinates& query, double max_distance) const {
    std::array<int, kCandidates> indices{};
    const std::size_t found = tree_->nearest(query, indices);
    SurfacePoint best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < found; ++i) {
      for (int f : around_[indices[i]]) {
        const auto [point, distance] = nearest_on(f, query);
        if (distance > least || (distance == least && point.face >= best.face)) continue;
        least = distance;
        best = point;
      }
    }
    if (best.face == kNoFace || gap(best, query) > max_distance) return {};
    return {source_face_[best.face], best.weights};
  }

 private:
  static constexpr std::size_t kCandidates = 6;

  Coordinates joined(const Point& position, const Point& normal) const {
    Coordinates result;
    result << position, normal_weight_ * normal;
    return result;
  }

  Coordinates image(const Mesh& target, const SurfacePoint& point) const {
    return joined(position(target, point), interpolated(target, normals_, point).normalized());
  }

  /// Closest in position on the face, and its squared distance in all.
  ClosestPoint nearest_on(int face, const Coordinates& query) const {
    const auto& [a, b, c] = faces_.faces[face];
    SurfacePoint point{face, closest_weights(query.head<3>(), points_[a].head<3>(),
                                             points_[b].head<3>(), points_[c].head<3>())};
    // Images that fall onto one place leave a face degenerate: its nearest corner stands for it.
    if (!std::isfinite(point.weights[0] + point.weights[1] + point.weights[2]))
      point.weights = nearest_corner(face, query);
    return {point, (interpolated(faces_, points_, point) - query).squaredNorm()};
  }

  std::array<double, 3> nearest_corner(int face, const Coordinates& query) const {
    int best = 0;
    for (int k = 1; k < 3; ++k) {
      const auto distance = [&](int corner) {
        return (points_[faces_.faces[face][corner]] - query).squaredNorm();
      };
      if (distance(k) < distance(best)) best = k;
    }
    std::array<double, 3> weights{};
    weights[best] = 1;
    return weights;
  }

  double gap(const SurfacePoint& point, const Coordinates& query) const {
    return (interpolated(faces_, points_, point) - query).head<3>().norm();
  }

  double normal_weight_;
  std::vector<Point> normals_;
  std::vector<Coordinates> points_;
  /// Between images; without positions.
  Mesh faces_;
  std::vector<int> source_face_;
  IndexLists around_;
  std::optional<KdTree<6>> tree_;
};

}  // namespace

void InversionOptions::validate() const {
  if (!std::isfinite(max_distance) || max_distance < 0)
    throw InvalidInput("max_distance must not be negative");
  if (!std::isfinite(normal_weight) || normal_weight < 0)
    throw InvalidInput("normal_weight must not be negative");
}

SurfaceMap invert_map(const Mesh& source, const Mesh& target, const SurfaceMap& source_to_target,
                      const InversionOptions& options, const Context& context) {
  options.validate();
  check_map(source_to_target, source.num_vertices(), target.num_faces());
  // Of vertices that are not finite or stray nothing is asked, and they spoil no other's normal.
  const std::vector<int> places = stand_ins(target);
  Mesh sound = target;
  for (std::size_t t = 0; t < places.size(); ++t) sound.vertices[t] = target.vertices[places[t]];
  const double unit = std::sqrt(surface_area(sound));
  const Images images(source, sound, source_to_target, options.normal_weight * unit);
  SurfaceMap result(target.vertices.size());
  if (images.empty()) return result;
  parallel_for(target.num_vertices(), context, [&](std::ptrdiff_t i) {
    const int t = static_cast<int>(i);
    if (places[t] == t)
      result[t] = images.nearest(images.coordinates(sound, t), options.max_distance * unit);
  });
  return result;
}

}  // namespace isomatch
