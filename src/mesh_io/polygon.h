// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "mesh_io/formats.h"

namespace isomatch::mesh_io {

/// One polygon, given corner by corner, as a fan of triangles around its first corner.
class Polygon {
 public:
  /// Appends to the faces of `result`.
  explicit Polygon(ReadResult& result) : result_(&result) {}

  void add_corner(int vertex) {
    if (corners_ == 0) first_ = vertex;
    if (corners_ >= 2) result_->mesh.faces.push_back({first_, previous_, vertex});
    // The fourth corner makes the polygon one that had to be cut.
    if (corners_ == 3) ++result_->report.triangulated_polygons;
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

}  // namespace isomatch::mesh_io
