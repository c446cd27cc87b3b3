// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/tangent_field.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "geometry/cotangent_laplacian.h"

namespace isomatch::tracked {
namespace {

double product(const TangentField& a, const TangentField& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += a[v].dot(b[v]);
  return sum;
}

}  // namespace

Connection::Connection(const Mesh& mesh, const std::vector<Point>& normals)
    : links_(mesh.vertices.size()) {
  for (const Point& normal : normals) frames_.push_back(tangent_frame(normal));
  const Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian = cotangent_laplacian(mesh);
  constexpr double kLeast = 1e-3;  // So that no vertex is on its own.
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    for (decltype(laplacian)::InnerIterator entry(laplacian, v); entry; ++entry) {
      const int w = static_cast<int>(entry.col());
      if (w == v) continue;
      links_[v].push_back({w, std::max(kLeast, -entry.value()), transport(w, v, normals)});
    }
  }
}

/// Tangent vectors of one vertex at another, by the shortest rotation between the normals.
Eigen::Matrix2d Connection::transport(int from, int to, const std::vector<Point>& normals) const {
  const auto rotation = Eigen::Quaterniond::FromTwoVectors(normals[from], normals[to]);
  Eigen::Matrix2d turn;
  turn.col(0) = frames_[to].coordinates(rotation * frames_[from].first);
  turn.col(1) = frames_[to].coordinates(rotation * frames_[from].second);
  return turn;
}

TangentField Connection::balanced(const std::vector<Pull>& pulls, double smoothness) const {
  // Exact enough for a step of an iteration, which the next one mends.
  constexpr int kMost = 60;
  constexpr double kTolerance = 1e-3;
  const std::vector<Eigen::Matrix2d> inverse = inverse_diagonal(pulls, smoothness);
  TangentField field(pulls.size(), Tangent::Zero()), direction = field, residual, scaled = field;
  for (const Pull& pull : pulls) residual.push_back(pull.force);
  double first = 0, old = 0;
  for (int iteration = 0; iteration < kMost; ++iteration) {
    for (std::size_t v = 0; v < field.size(); ++v) scaled[v] = inverse[v] * residual[v];
    const double left = product(residual, scaled);
    if (iteration == 0) first = left;
    if (left <= kTolerance * kTolerance * first) break;
    const double share = iteration == 0 ? 0 : left / old;
    old = left;
    for (std::size_t v = 0; v < field.size(); ++v) direction[v] = scaled[v] + share * direction[v];
    const TangentField image = resistance(pulls, smoothness, direction);
    const double step = left / product(image, direction);
    for (std::size_t v = 0; v < field.size(); ++v) {
      field[v] += step * direction[v];
      residual[v] -= step * image[v];
    }
  }
  return field;
}

/// Of the system that is solved, the inverse of what each vertex has to do with itself.
std::vector<Eigen::Matrix2d> Connection::inverse_diagonal(const std::vector<Pull>& pulls,
                                                          double smoothness) const {
  std::vector<Eigen::Matrix2d> inverse;
  for (std::size_t v = 0; v < pulls.size(); ++v) {
    double weight = 0;
    for (const Link& link : links_[v]) weight += link.weight;
    inverse.push_back(
        (pulls[v].stiffness + smoothness * weight * Eigen::Matrix2d::Identity()).inverse());
  }
  return inverse;
}

/// What pulls and links do against a field: the system that is solved, times it.
TangentField Connection::resistance(const std::vector<Pull>& pulls, double smoothness,
                                    const TangentField& field) const {
  TangentField forces;
  for (std::size_t v = 0; v < field.size(); ++v) {
    forces.push_back(pulls[v].stiffness * field[v]);
    for (const Link& link : links_[v])
      forces.back() += smoothness * link.weight * (field[v] - link.turn * field[link.to]);
  }
  return forces;
}

}  // namespace isomatch::tracked
