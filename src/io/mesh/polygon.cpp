// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/polygon.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/tangent_frame.h"
#include "io/mesh/tessellator.h"

namespace isomatch::mesh_io {
namespace {

using Triangle = Tessellator::Triangle;
using Outline = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// What a polygon looks like along its normal.
struct View {
  /// Counter-clockwise, about 1 wide; empty if the polygon has no area.
  Outline outline;
  /// Corners at which it turns clockwise, or back.
  std::vector<int> reflex;
  /// Full turns of its edges; more than one is a star.
  double turns = 0;
};

/// From the first corner, at most 1 long.
std::vector<Point> unit_sized(std::vector<Point> corners) {
  const Point origin = corners[0];
  double extent = 0;
  for (Point& corner : corners) {
    corner -= origin;
    extent = std::max(extent, corner.lpNorm<Eigen::Infinity>());
  }
  for (Point& corner : corners) corner /= extent;
  return corners;
}

Outline outline_of(std::vector<Point> corners) {
  corners = unit_sized(std::move(corners));
  const std::size_t n = corners.size();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < n; ++k) normal += corners[k].cross(corners[(k + 1) % n]);
  // Less is the rounding of a polygon without area. Not a number if all corners are in one place.
  constexpr double kLeast = 1e-12;
  if (!(normal.norm() > kLeast)) return {};
  normal.normalize();
  const TangentFrame frame = tangent_frame(normal);
  Outline outline;
  for (const Point& corner : corners) outline.push_back(frame.coordinates(corner));
  return outline;
}

View view_of(const std::vector<Point>& corners) {
  // Straight corners of 32-bit coordinates may be this much off; folds of such angles do not show.
  constexpr double kStraight = 1e-6;
  View view{outline_of(corners), {}, 0};
  const std::size_t n = view.outline.size();
  std::vector<int> distinct;
  for (std::size_t k = 0; k < n; ++k)
    if (view.outline[k] != view.outline[(k + 1) % n]) distinct.push_back(static_cast<int>(k));
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const auto edge = [&](int k) -> Eigen::Vector2d {
      return view.outline[(k + 1) % n] - view.outline[k];
    };
    const int here = distinct[i];
    const Eigen::Vector2d before =
        edge(distinct[(i + distinct.size() - 1) % distinct.size()]).normalized();
    const Eigen::Vector2d after = edge(here).normalized();
    const double turn = std::atan2(cross(before, after), before.dot(after));
    view.turns += turn / (2 * std::numbers::pi);
    if (turn < -kStraight || turn > std::numbers::pi - kStraight) view.reflex.push_back(here);
  }
  return view;
}

/// By the numbers of a polygon's corners.
using Triangles = std::vector<Triangle>;

enum class Fate { kStaysFan, kIsCut, kIntersectsItself };

/// Cuts the polygons of a mesh that has been read.
class Cutter {
 public:
  explicit Cutter(ReadResult& result) : result_(result) {}

  void run() {
    for (const Fan& fan : result_.fans) {
      const Fate fate = decide(fan);
      if (fate == Fate::kIsCut) changes_.push_back({fan, std::move(triangles_)});
      if (fate == Fate::kIntersectsItself) ++self_intersecting_;
    }
    if (!changes_.empty()) replace_fans();
    if (self_intersecting_ > 0)
      result_.report.warnings.push_back(
          fmt::format("polygons that intersect themselves, and are cut as if they were convex: {}",
                      self_intersecting_));
  }

 private:
  /// What takes the place of a fan.
  struct Change {
    Fan fan;
    Triangles triangles;
  };

  /// The corners of a fan's triangles, in the polygon's order.
  template <class Element>
  static std::vector<int> corners_of(const Fan& fan, const std::vector<Element>& triangles) {
    std::vector<int> corners{triangles[fan.first_face][0], triangles[fan.first_face][1]};
    for (std::size_t f = 0; f < fan.faces; ++f) corners.push_back(triangles[fan.first_face + f][2]);
    return corners;
  }

  /// Fills `triangles_` if the polygon is cut. The polygon is seen from its lowest vertex on, so
  /// that nothing depends on where it began.
  Fate decide(const Fan& fan) {
    const std::vector<int> vertices = corners_of(fan, result_.mesh.faces);
    const std::size_t n = vertices.size();
    const std::size_t shift = std::ranges::min_element(vertices) - vertices.begin();
    std::vector<Point> corners;
    for (std::size_t k = 0; k < n; ++k)
      corners.push_back(result_.mesh.vertices[vertices[(k + shift) % n]]);
    const View view = view_of(corners);
    const bool is_convex = view.reflex.empty() && view.turns < 1.5;
    if (view.outline.empty() || is_convex) return Fate::kStaysFan;
    if (n == 4) return decide_quad(view, shift);
    std::optional<Triangles> triangles = tessellator_.cut(view.outline);
    if (!triangles) return Fate::kIntersectsItself;
    triangles_ = std::move(*triangles);
    for (Triangle& triangle : triangles_)
      for (int& corner : triangle) corner = static_cast<int>((corner + shift) % n);
    return Fate::kIsCut;
  }

  /// The diagonal must end in the corner that turns back.
  Fate decide_quad(const View& view, std::size_t shift) {
    if (view.reflex.size() != 1) return Fate::kIntersectsItself;
    if ((view.reflex[0] + shift) % 2 == 0) return Fate::kStaysFan;
    triangles_ = {{1, 2, 3}, {1, 3, 0}};
    return Fate::kIsCut;
  }

  void replace_fans() {
    Texture& texture = result_.texture;
    if (texture.corners.size() == result_.mesh.faces.size()) {
      texture.corners = with_changes(texture.corners, corners_of_triangle<std::array<int, 3>>);
      texture.face_material = with_changes(texture.face_material, material_of_triangle);
    }
    result_.mesh.faces = with_changes(result_.mesh.faces, corners_of_triangle<Face>);
  }

  template <class Element>
  static void corners_of_triangle(const std::vector<Element>& old, const Change& change,
                                  std::vector<Element>& result) {
    const std::vector<int> corners = corners_of(change.fan, old);
    for (const auto& [a, b, c] : change.triangles)
      result.push_back({corners[a], corners[b], corners[c]});
  }

  static void material_of_triangle(const std::vector<int>& old, const Change& change,
                                   std::vector<int>& result) {
    result.insert(result.end(), change.triangles.size(), old[change.fan.first_face]);
  }

  /// `old`, of which each face has an element, with what `append` makes of the changes.
  template <class Element, class Append>
  std::vector<Element> with_changes(const std::vector<Element>& old, const Append& append) const {
    std::vector<Element> result;
    result.reserve(old.size());
    auto rest = old.begin();
    for (const Change& change : changes_) {
      result.insert(result.end(), rest, old.begin() + change.fan.first_face);
      append(old, change, result);
      rest = old.begin() + change.fan.first_face + change.fan.faces;
    }
    result.insert(result.end(), rest, old.end());
    return result;
  }

  ReadResult& result_;
  Tessellator tessellator_;
  Triangles triangles_;
  std::vector<Change> changes_;
  int self_intersecting_ = 0;
};

}  // namespace

void cut_polygons(ReadResult& result) {
  if (!result.fans.empty()) Cutter(result).run();
  result.fans.clear();
}

}  // namespace isomatch::mesh_io
