// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::synth {

/// A closed manifold triangulation that can be edited. Corner c is corner c % 3 of face c / 3; the
/// edge *of* a corner is the one opposite it in its face. Every edit keeps the surface a closed
/// manifold of the same genus. Faces and vertices that vanish leave gaps until `compact`.
class CornerTable {
 public:
  /// `faces` must be a closed, consistently oriented manifold. O(N log N).
  explicit CornerTable(const Mesh& mesh);

  static int next(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  static int previous(int corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

  int num_corners() const { return static_cast<int>(vertex_.size()); }
  int num_vertices() const { return static_cast<int>(corner_.size()); }
  int num_live_vertices() const { return live_vertices_; }
  /// False for corners of vanished faces.
  bool is_live(int corner) const { return vertex_[corner] >= 0; }
  int vertex(int corner) const { return vertex_[corner]; }
  /// The corner across the edge of `corner`.
  int opposite(int corner) const { return opposite_[corner]; }
  /// Some corner at `vertex`, -1 for one that vanished.
  int corner(int vertex) const { return corner_[vertex]; }
  /// The next corner around the same vertex.
  int swing(int corner) const { return next(opposite_[next(corner)]); }
  /// The ends of the edge of `corner`.
  int from(int corner) const { return vertex_[next(corner)]; }
  int to(int corner) const { return vertex_[previous(corner)]; }

  /// Calls `visit(corner)` for each corner around `vertex`.
  template <class Visit>
  void around(int vertex, Visit&& visit) const {
    const int first = corner_[vertex];
    int corner = first;
    do visit(corner);
    while ((corner = swing(corner)) != first);
  }

  bool adjacent(int a, int b) const;

  /// Turns the edge of `corner` within its two faces. False, and nothing is done, if the edge that
  /// would result exists already.
  bool flip(int corner);
  /// Divides the edge of `corner` by a new vertex, whose index is returned.
  int split(int corner);
  /// True if the edge of `corner` can shrink to a point without pinching the surface.
  bool can_collapse(int corner) const;
  /// Shrinks the edge of `corner` into its vertex `from`; `to` vanishes. Needs `can_collapse`.
  void collapse(int corner);

  /// Divides every face into four. Returns the ends of the edges in whose middle the new vertices
  /// lie; these are numbered after the old ones in this order. Needs a compact table.
  std::vector<std::array<int, 2>> subdivide();

  /// Closes the gaps. Returns for each remaining vertex its index before.
  std::vector<int> compact();

  /// The faces of a compact table.
  std::vector<Face> faces() const;

 private:
  void link(int a, int b);
  int add_face(const Face& face);
  void remove_face_of(int corner);

  std::vector<int> vertex_;
  std::vector<int> opposite_;
  std::vector<int> corner_;
  int live_vertices_ = 0;
};

}  // namespace isomatch::synth
