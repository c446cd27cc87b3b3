// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "gmds/stress.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace isomatch::baselines {
namespace {

/// The minimum of u.F u on the segment from `a` to `b`.
Eigen::Vector3d minimum_between(const Eigen::Matrix3d& form, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b) {
  const Eigen::Vector3d d = b - a;
  const double curvature = d.dot(form * d);
  if (curvature <= 0) return b.dot(form * b) < a.dot(form * a) ? b : a;
  return a + std::clamp(-d.dot(form * a) / curvature, 0.0, 1.0) * d;
}

/// The minimum of u.F u over barycentric weights u.
Eigen::Vector3d minimum_on_triangle(const Eigen::Matrix3d& form) {
  const Eigen::Vector3d normal = form.fullPivLu().solve(Eigen::Vector3d::Ones());
  const Eigen::Vector3d inner = normal / normal.sum();
  if (inner.allFinite() && inner.minCoeff() >= 0) return inner;
  const Eigen::Matrix3d corners = Eigen::Matrix3d::Identity();
  Eigen::Vector3d best = corners.col(0);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d u = minimum_between(form, corners.col(k), corners.col((k + 1) % 3));
    if (u.dot(form * u) < best.dot(form * best)) best = u;
  }
  return best;
}

}  // namespace

DistanceTable::DistanceTable(const MetricSurface& shape, const Context& context)
    : n_(shape.num_vertices()) {
  std::vector<int> vertices(n_);
  std::iota(vertices.begin(), vertices.end(), 0);
  values_ = geodesic_fields(shape.graph(), vertices, context);
  for (float& value : values_) value /= static_cast<float>(shape.max_geodesic());
}

double DistanceTable::operator()(const Mesh& mesh, const SurfacePoint& a,
                                 const SurfacePoint& b) const {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    if (a.weights[i] == 0) continue;
    for (int j = 0; j < 3; ++j)
      sum += a.weights[i] * b.weights[j] * (*this)(mesh.faces[a.face][i], mesh.faces[b.face][j]);
  }
  return sum;
}

struct Stress::Place {
  SurfacePoint point;
  double stress = std::numeric_limits<double>::infinity();
};

Stress::Stress(const MetricSurface& target, const DistanceTable& distances,
               const Eigen::MatrixXd& wanted)
    : target_(target),
      distances_(distances),
      wanted_(wanted),
      faces_of_vertex_(vertex_faces(target.mesh())) {}

double Stress::total(const SurfaceMap& points) const {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double difference = distances_(target_.mesh(), points[i], points[j]) - wanted_(i, j);
      sum += difference * difference;
    }
  }
  return sum;
}

SurfacePoint Stress::at_vertex(int vertex) const {
  SurfacePoint point{faces_of_vertex_[vertex].front(), {}};
  const Face& face = target_.mesh().faces[point.face];
  point.weights[std::ranges::find(face, vertex) - face.begin()] = 1;
  return point;
}

SurfacePoint Stress::best_vertex(const SurfaceMap& points, int moving) const {
  const Mesh& mesh = target_.mesh();
  std::vector<double> stress(mesh.vertices.size(), 0.0);
  for (int j = 0; j < std::ssize(points); ++j) {
    if (j == moving) continue;
    const Face& face = mesh.faces[points[j].face];
    const auto& w = points[j].weights;
    for (int v = 0; v < mesh.num_vertices(); ++v) {
      const double distance = w[0] * distances_(face[0], v) + w[1] * distances_(face[1], v) +
                              w[2] * distances_(face[2], v);
      stress[v] += (distance - wanted_(moving, j)) * (distance - wanted_(moving, j));
    }
  }
  const int best = static_cast<int>(std::ranges::min_element(stress) - stress.begin());
  return at_vertex(best);
}

Eigen::MatrixX3d Stress::corner_distances(const SurfaceMap& points, int moving, int face) const {
  const Mesh& mesh = target_.mesh();
  Eigen::MatrixX3d differences(points.size() - 1, 3);
  Eigen::Index row = 0;
  for (int j = 0; j < std::ssize(points); ++j) {
    if (j == moving) continue;
    const Face& other = mesh.faces[points[j].face];
    const auto& w = points[j].weights;
    for (int k = 0; k < 3; ++k) {
      const int corner = mesh.faces[face][k];
      differences(row, k) = w[0] * distances_(other[0], corner) +
                            w[1] * distances_(other[1], corner) +
                            w[2] * distances_(other[2], corner) - wanted_(moving, j);
    }
    ++row;
  }
  return differences;
}

Stress::Place Stress::best_on_face(const SurfaceMap& points, int moving, int face) const {
  // Weights sum to one, so that the wanted distances can be taken off every corner.
  const Eigen::MatrixX3d differences = corner_distances(points, moving, face);
  const Eigen::Matrix3d form = differences.transpose() * differences;
  const Eigen::Vector3d u = minimum_on_triangle(form);
  return {{face, {u[0], u[1], u[2]}}, u.dot(form * u)};
}

void Stress::improve(SurfaceMap& points, int moving) const {
  const Mesh& mesh = target_.mesh();
  Place best = best_on_face(points, moving, points[moving].face);
  std::set<int> seen{points[moving].face};
  for (bool moved = true; moved;) {
    moved = false;
    const SurfacePoint from = best.point;
    // A point inside has no neighbour, one on an edge a face, one at a corner all around it.
    std::set<int> around;
    for (int k = 0; k < 3; ++k) {
      if (from.weights[k] > 0) around.insert(mesh.faces[from.face][k]);
    }
    if (around.size() == 3) break;
    for (int face : faces_of_vertex_[*around.begin()]) {
      const bool touches = std::ranges::all_of(
          around, [&](int v) { return std::ranges::count(mesh.faces[face], v) > 0; });
      if (!touches || !seen.insert(face).second) continue;
      const Place place = best_on_face(points, moving, face);
      if (place.stress < best.stress) {
        best = place;
        moved = true;
      }
    }
  }
  points[moving] = best.point;
}

}  // namespace isomatch::baselines
