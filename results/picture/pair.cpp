// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/pair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isomatch::picture {
namespace {

/// Where a portrait lies in the viewer's frame.
Eigen::AlignedBox3d seen_box(const Portrait& portrait) {
  Eigen::AlignedBox3d box;
  for (const Point& p : portrait.mesh.vertices) box.extend(portrait.rotation * p);
  return box;
}

}  // namespace

Image draw_pair(const Portrait& left, const Portrait& right, int width, const Color& background) {
  const double margin = 0.03 * width;
  const Eigen::AlignedBox3d boxes[] = {seen_box(left), seen_box(right)};
  const double units[] = {std::sqrt(surface_area(left.mesh)), std::sqrt(surface_area(right.mesh))};
  const Point sizes[] = {boxes[0].sizes() / units[0], boxes[1].sizes() / units[1]};
  const double height = std::max(sizes[0].y(), sizes[1].y());
  const double scale =
      std::min((width - 3 * margin) / (sizes[0].x() + sizes[1].x()), (width - 2 * margin) / height);
  Canvas canvas(width, static_cast<int>(std::ceil(scale * height + 2 * margin)), background);
  // What room is left over goes evenly before, between and behind the two.
  const double gap = (width - scale * (sizes[0].x() + sizes[1].x())) / 3;
  double x = gap;
  for (int side = 0; side < 2; ++side) {
    const Portrait& portrait = side == 0 ? left : right;
    const double extent = scale * sizes[side].x();
    const Projection projection{portrait.rotation,
                                portrait.rotation.transpose() * boxes[side].center(),
                                {x + extent / 2, margin + scale * height / 2},
                                scale / units[side]};
    std::visit([&](const auto& look) { canvas.draw(portrait.mesh, look, projection); },
               portrait.look);
    x += extent + gap;
  }
  return canvas.image();
}

}  // namespace isomatch::picture
