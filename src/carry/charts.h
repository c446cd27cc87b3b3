// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/closest_point.h"
#include "geometry/weld.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/texture.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::transfer {

/// A ball in space.
struct Ball {
  Point centre;
  double radius;
};

/// A textured surface, cut along the seams of its texture.
class Charts {
 public:
  /// Keeps a reference to `texture`.
  Charts(const Mesh& mesh, const Texture& texture);

  const Mesh& mesh() const { return welded_.mesh; }
  const IndexLists& vertex_faces() const { return vertex_faces_; }

  /// The faces in `ball` that can be reached from `starts` in it without crossing a seam, nearest
  /// (in steps) first. `starts` belong to it wherever they are.
  std::vector<int> grow(std::span<const int> starts, const Ball& ball) const;

  /// All faces that hold `point`, which lies on a seam if it is between several charts.
  std::vector<int> faces_at(const SurfacePoint& point) const;

  /// The coordinates at a point of a face that the texture covers.
  Eigen::Vector2d coordinates(const SurfacePoint& point) const;

 private:
  bool is_seam(int face, int neighbour) const;
  Eigen::Vector2d corner_coordinates(int face, int vertex) const;

  const Texture& texture_;
  WeldedMesh welded_;
  IndexLists vertex_faces_;
  /// Across the edge opposite each corner; `kNoFace` across a seam.
  std::vector<std::array<int, 3>> neighbours_;
};

/// The closest of the points of `faces` to `p`; of those that are equally close up to rounding,
/// that on the first face.
ClosestPoint nearest_point(const Mesh& mesh, std::span<const int> faces, const Point& p);

}  // namespace isomatch::transfer
