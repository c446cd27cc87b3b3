// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/geodesics/geodesics.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {

/// Triangles that a strip may cross before it is given up. Windows of one depth are disjoint and
/// none is narrower than the window angle, so this bounds the work at a vertex even on slivers.
inline constexpr int kMaxStripLength = 64;

/// Finds the straight lines from a vertex to the vertices it sees across unfolded triangle strips.
class StripUnfolder {
 public:
  /// Keeps references to all arguments but the angle, which is in degrees.
  StripUnfolder(const Mesh& mesh, const IndexLists& faces_of_vertex,
                const std::vector<std::array<int, 3>>& neighbours, double window_angle);

  /// Appends an arc for every edge of `vertex` and every vertex visible from it, in no particular
  /// order and possibly more than one to the same head. Lengths are rounded up, so that an arc is
  /// never shorter than the line it stands for.
  void append_arcs(int vertex, std::vector<GeodesicGraph::Arc>& arcs);

 private:
  using Vector2 = Eigen::Vector2d;

  /// What is seen through edge (right, left) of a strip, in the plane with the vertex at the
  /// origin; right comes before left counterclockwise.
  struct Window {
    int face;  ///< The face beyond the edge.
    int depth;
    int right, left;
    Vector2 right_position, left_position;
    Vector2 right_ray, left_ray;  ///< Unit vectors that bound the window.
  };

  void open_window(int face, std::vector<GeodesicGraph::Arc>& arcs);
  void look_through(const Window& window, std::vector<GeodesicGraph::Arc>& arcs);
  void push_if_wide(const Window& window);
  /// Where the third vertex of the face beyond the window's edge lies in the plane. Not finite if
  /// the edge has no length.
  Vector2 unfold(const Window& window, int apex) const;

  const Mesh& mesh_;
  const IndexLists& faces_of_vertex_;
  const std::vector<std::array<int, 3>>& neighbours_;
  double cos_window_angle_;
  int vertex_ = 0;  ///< The one whose arcs are being found.
  std::vector<Window> stack_;
};

}  // namespace isomatch
