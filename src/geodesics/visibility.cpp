// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geodesics/visibility.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

namespace isomatch {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

float round_up(double length) {
  const auto rounded = static_cast<float>(length);
  return rounded >= length ? rounded : std::nextafter(rounded, std::numeric_limits<float>::max());
}

int corner_of(const Face& face, int vertex) {
  return face[0] == vertex ? 0 : face[1] == vertex ? 1 : 2;
}

}  // namespace

StripUnfolder::StripUnfolder(const Mesh& mesh, const IndexLists& faces_of_vertex,
                             const std::vector<std::array<int, 3>>& neighbours, double window_angle)
    : mesh_(mesh),
      faces_of_vertex_(faces_of_vertex),
      neighbours_(neighbours),
      cos_window_angle_(std::cos(window_angle * std::numbers::pi / 180)) {}

void StripUnfolder::append_arcs(int vertex, std::vector<GeodesicGraph::Arc>& arcs) {
  vertex_ = vertex;
  for (const int face : faces_of_vertex_[vertex]) {
    open_window(face, arcs);
    while (!stack_.empty()) {
      const Window window = stack_.back();
      stack_.pop_back();
      look_through(window, arcs);
    }
  }
}

void StripUnfolder::open_window(int face, std::vector<GeodesicGraph::Arc>& arcs) {
  const int corner = corner_of(mesh_.faces[face], vertex_);
  const int right = mesh_.faces[face][(corner + 1) % 3];
  const int left = mesh_.faces[face][(corner + 2) % 3];
  const Point to_right = mesh_.vertices[right] - mesh_.vertices[vertex_];
  const Point to_left = mesh_.vertices[left] - mesh_.vertices[vertex_];
  const double right_length = to_right.norm(), left_length = to_left.norm();
  if (right != vertex_) arcs.push_back({right, round_up(right_length)});
  if (left != vertex_) arcs.push_back({left, round_up(left_length)});
  if (!(right_length > 0 && left_length > 0)) return;
  const Vector2 left_position(to_right.dot(to_left) / right_length,
                              to_right.cross(to_left).norm() / right_length);
  push_if_wide({neighbours_[face][corner], 1, right, left, Vector2(right_length, 0), left_position,
                Vector2(1, 0), left_position / left_length});
}

void StripUnfolder::push_if_wide(const Window& window) {
  if (window.face == kNoFace || window.depth > kMaxStripLength) return;
  if (window.right_ray.dot(window.left_ray) > cos_window_angle_) return;
  stack_.push_back(window);
}

Vector2d StripUnfolder::unfold(const Window& window, int apex) const {
  // Orientation plays no part: the apex is placed on the far side of the edge, wherever it is.
  const Point edge = mesh_.vertices[window.left] - mesh_.vertices[window.right];
  const Point side = mesh_.vertices[apex] - mesh_.vertices[window.right];
  const double scale = 1 / edge.squaredNorm();
  const double along = edge.dot(side) * scale, across = edge.cross(side).norm() * scale;
  const Vector2d flat_edge = window.left_position - window.right_position;
  return window.right_position + along * flat_edge +
         across * Vector2d(flat_edge.y(), -flat_edge.x());
}

void StripUnfolder::look_through(const Window& window, std::vector<GeodesicGraph::Arc>& arcs) {
  const Face& face = mesh_.faces[window.face];
  const int right_corner = corner_of(face, window.right);
  const int left_corner = corner_of(face, window.left);
  const int apex = face[3 - right_corner - left_corner];
  if (apex == window.right || apex == window.left) return;
  const Vector2d position = unfold(window, apex);

  const bool right_sees = cross(window.right_ray, position) > 0;
  const bool left_sees = cross(position, window.left_ray) > 0;
  Vector2d left_ray = window.left_ray, right_ray = window.right_ray;
  if (right_sees && left_sees) {
    const double length = position.norm();
    // Round a thin limb a vertex sees itself.
    if (apex != vertex_) arcs.push_back({apex, round_up(length)});
    left_ray = right_ray = position / length;
  }
  const auto& beyond = neighbours_[window.face];
  if (right_sees) {
    push_if_wide({beyond[left_corner], window.depth + 1, window.right, apex, window.right_position,
                  position, window.right_ray, left_ray});
  }
  if (left_sees) {
    push_if_wide({beyond[right_corner], window.depth + 1, apex, window.left, position,
                  window.left_position, right_ray, window.left_ray});
  }
}

}  // namespace isomatch
