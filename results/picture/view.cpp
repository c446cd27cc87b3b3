// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace isomatch::picture {
namespace {

Eigen::AlignedBox3d bounding_box(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Point& p : mesh.vertices) box.extend(p);
  return box;
}

/// Centre of the surface, each face weighted by its area.
Point centroid(const Mesh& mesh) {
  Point sum = Point::Zero();
  double area = 0;
  for (int f = 0; f < mesh.num_faces(); ++f) {
    const Face& face = mesh.faces[f];
    const double weight = face_area(mesh, f);
    sum += weight / 3 * (mesh.vertices[face[0]] + mesh.vertices[face[1]] + mesh.vertices[face[2]]);
    area += weight;
  }
  return area > 0 ? Point(sum / area) : mesh.vertices.front();
}

/// Whether the centre of the shape lies above what it would stand on, in the sense that points to
/// stand on are found on all sides of it.
bool stands(const Mesh& mesh, int axis) {
  constexpr double kFoot = 0.04;
  constexpr int kSectors = 8;
  const Eigen::AlignedBox3d box = bounding_box(mesh);
  const Point centre = centroid(mesh);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<bool, kSectors> supported{};
  for (const Point& p : mesh.vertices) {
    if (p[axis] > box.min()[axis] + kFoot * box.sizes()[axis]) continue;
    const double angle = std::atan2(p[v] - centre[v], p[u] - centre[u]) / (2 * std::numbers::pi);
    supported[std::min(static_cast<int>((angle + 0.5) * kSectors), kSectors - 1)] = true;
  }
  // Nowhere a half turn without support.
  int gap = 0, widest = 0;
  for (int i = 0; i < 2 * kSectors; ++i) {
    gap = supported[i % kSectors] ? 0 : gap + 1;
    widest = std::max(widest, gap);
  }
  return widest < kSectors / 2;
}

/// Rows right, up, towards the viewer, who looks along `-towards`.
Eigen::Matrix3d frame(const Point& up, const Point& towards) {
  const Point right = up.cross(towards).normalized();
  Eigen::Matrix3d rows;
  rows << right.transpose(), towards.cross(right).normalized().transpose(),
      towards.normalized().transpose();
  return rows;
}

/// Twice the area that faces turned towards this direction or away from it show there.
double projected_area(const Mesh& mesh, const Point& towards) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    const Point& p = mesh.vertices[face[0]];
    sum += std::abs((mesh.vertices[face[1]] - p).cross(mesh.vertices[face[2]] - p).dot(towards));
  }
  return sum;
}

Point turned(const Point& direction, const Point& up, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, up) * direction;
}

}  // namespace

std::optional<Point> parse_axis(std::string_view name) {
  const double sign = name.starts_with('-') ? -1 : 1;
  if (sign < 0) name.remove_prefix(1);
  if (name == "x") return sign * Point::UnitX();
  if (name == "y") return sign * Point::UnitY();
  if (name == "z") return sign * Point::UnitZ();
  return std::nullopt;
}

Point guess_up(const Mesh& mesh) {
  const Point sizes = bounding_box(mesh).sizes();
  int thinnest = 0;
  sizes.minCoeff(&thinnest);
  if (thinnest == 2) return Point::UnitY();
  if (thinnest == 1) return Point::UnitZ();
  return !stands(mesh, 1) && stands(mesh, 2) ? Point::UnitZ() : Point::UnitY();
}

Eigen::Matrix3d choose_view(const Mesh& mesh, const Point& up, double turn) {
  constexpr double kStep = 7.5, kElevation = 12;
  const Point front = std::abs(up.z()) > 0.5 ? Point(-Point::UnitY()) : Point::UnitZ();
  const Point start = (front - front.dot(up) * up).norm() > 0.5 ? front : Point(Point::UnitX());
  double best_angle = 0, best_area = -1;
  // By rising angle from the front, so that the nearer of equal ones counts.
  for (double angle = 0; angle <= 90; angle += kStep) {
    for (const double signed_angle : {angle, -angle}) {
      const double area = projected_area(mesh, turned(start, up, signed_angle));
      if (area <= best_area * (1 + 1e-6)) continue;
      best_area = area;
      best_angle = signed_angle;
    }
  }
  const Point level = turned(start, up, best_angle + turn);
  const double elevation = kElevation * std::numbers::pi / 180;
  return frame(up, std::cos(elevation) * level + std::sin(elevation) * up);
}

}  // namespace isomatch::picture
