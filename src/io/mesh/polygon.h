// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "io/mesh/formats.h"

namespace isomatch::mesh_io {

/// One polygon, given corner by corner, as a fan of triangles around its first corner, which
/// `cut_polygons` may replace when all vertices are known. With fewer than three corners it is no
/// face, but counted.
class Polygon {
 public:
  /// Appends to the faces of `result`.
  explicit Polygon(ReadResult& result) : result_(&result) {}
  Polygon(const Polygon&) = delete;
  Polygon& operator=(const Polygon&) = delete;
  ~Polygon() {
    if (corners_ < 3) ++result_->short_faces;
  }

  void add_corner(int vertex) {
    if (corners_ == 0) first_ = vertex;
    if (corners_ >= 2) result_->mesh.faces.push_back({first_, previous_, vertex});
    // The fourth corner makes the polygon one that has to be cut.
    if (corners_ == 3) {
      ++result_->report.triangulated_polygons;
      result_->fans.push_back({result_->mesh.faces.size() - 2, 1});
    }
    if (corners_ >= 3) ++result_->fans.back().faces;
    previous_ = vertex;
    ++corners_;
  }

  std::size_t corners() const { return corners_; }

 private:
  ReadResult* result_;
  std::size_t corners_ = 0;
  int first_ = 0;
  int previous_ = 0;
};

/// Replaces the fans of `result` that fold back on themselves: a concave polygon is cut into other
/// triangles between its corners, of the same orientation, which together have its area; where in
/// `Polygon` it began makes no difference. Everything is seen along the polygon's mean normal
/// (Newell's), so that polygons need not be flat. Convex polygons stay fans, and so do polygons
/// without area, and those that intersect themselves, of which a warning tells. Texture
/// coordinates and materials follow. O(N log N) but for many concave corners in one polygon.
void cut_polygons(ReadResult& result);

}  // namespace isomatch::mesh_io
