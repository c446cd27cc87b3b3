// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <vector>

#include "isomatch/context.h"
#include "synth/corner_table.h"
#include "synth/skin.h"

namespace isomatch::synth {

/// Edits a triangulation of a skin so that its triangles become even in the pose. Vertices stay on
/// the skin, faces keep their orientation.
class Remesher {
 public:
  /// Keeps references to `body`, `pose` and `context`. `mesh` triangulates the skin at rest.
  Remesher(const Body& body, const Pose& pose, const Mesh& mesh, const Context& context);

  int num_vertices() const { return table_.num_live_vertices(); }
  double area() const;

  /// Splits edges that are longer than `length`, once.
  void split_above(double length);
  /// Shrinks edges, the shortest first, until `vertices` are left.
  void collapse_to(int vertices);
  /// Flips edges until the triangulation is Delaunay, except where it bends sharply.
  void flip();
  /// Moves vertices towards the centres of their neighbourhoods.
  void relax();
  /// Divides every face into four.
  void subdivide();

  /// The result. The remesher is spent afterwards.
  Skin take();

 private:
  struct Edge {
    double length;
    int corner, from, to;
  };

  double squared_length(int corner) const;
  bool flip_improves(int corner) const;
  /// Where the edge of `corner` may collapse to; nothing if that would fold the skin.
  std::optional<Point> collapse_target(int corner) const;
  bool fits(int vertex, int other, const Point& target, const Vector& normal) const;
  Point relaxed(int vertex) const;
  /// Least quality of the triangles around `vertex` if it were at `p`, at rest.
  double star_quality(int vertex, const Point& p) const;
  void compact();

  const Body* body_;
  const Pose* pose_;
  const Context* context_;
  CornerTable table_;
  std::vector<Point> rest_, posed_;
};

}  // namespace isomatch::synth
