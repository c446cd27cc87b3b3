// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

class GLUtesselator;

namespace isomatch::mesh_io {

/// Cuts polygons in the plane into triangles, by the tessellator of GLU, which needs no display.
class Tessellator {
 public:
  using Triangle = std::array<int, 3>;

  Tessellator();

  /// Counter-clockwise triangles between the corners, by their numbers, that cover the inside of a
  /// counter-clockwise polygon, whose coordinates should be about 1. Where corners coincide, one
  /// may stand for the others. Nothing if the polygon intersects itself.
  std::optional<std::vector<Triangle>> cut(std::span<const Eigen::Vector2d> corners);

 private:
  struct Delete {
    void operator()(GLUtesselator* tessellator) const;
  };
  std::unique_ptr<GLUtesselator, Delete> tessellator_;
};

}  // namespace isomatch::mesh_io
