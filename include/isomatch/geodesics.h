// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/mesh.h"

namespace isomatch {

/// Which graph carries the distances.
enum class GeodesicArcs {
  kEdges,       ///< The mesh's edges, as in the paper (5 to 6 % too long).
  kVisibility,  ///< Edges and straight lines across unfolded triangle strips.
};

struct GeodesicOptions {
  GeodesicArcs arcs = GeodesicArcs::kVisibility;
  /// Visibility windows of less than this angle, in degrees, are not divided further. Smaller is
  /// more accurate and slower. In (0, 60]. Not used by `kEdges`.
  double window_angle = 20.0;

  /// Mean error .22 % of the exact distance.
  static GeodesicOptions w20() { return {GeodesicArcs::kVisibility, 20.0}; }
  /// Mean error .06 %, about 1.6 times the time of `w20`.
  static GeodesicOptions w10() { return {GeodesicArcs::kVisibility, 10.0}; }
  /// Dijkstra's algorithm over mesh edges (Section 3 of the paper).
  static GeodesicOptions edges() { return {GeodesicArcs::kEdges, 20.0}; }

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

/// A graph over the vertices of a mesh whose shortest paths approximate geodesics from above.
/// Lengths are in units of the coordinates. Immutable after construction, safe to share by threads.
class GeodesicGraph {
 public:
  struct Arc {
    int head;
    float length;
  };

  /// Builds the graph; O(N) with about 6 arcs a vertex for `kEdges`, 24 for W20, 48 for W10.
  explicit GeodesicGraph(const Mesh& mesh, const GeodesicOptions& options = {},
                         const Context& context = {});

  int num_vertices() const { return static_cast<int>(offsets_.size()) - 1; }
  std::size_t num_arcs() const { return arcs_.size(); }
  std::span<const Arc> arcs(int vertex) const {
    return {arcs_.data() + offsets_[vertex], arcs_.data() + offsets_[vertex + 1]};
  }
  /// Mean length of the mesh's edges.
  float mean_edge_length() const { return mean_edge_length_; }

 private:
  std::vector<std::size_t> offsets_;
  std::vector<Arc> arcs_;
  float mean_edge_length_ = 0;
};

/// Shortest path searches on one graph, with the scratch memory they share: create one per thread.
class GeodesicSearch {
 public:
  struct Reached {
    int vertex;
    float distance;
  };

  /// Keeps a reference to `graph`.
  explicit GeodesicSearch(const GeodesicGraph& graph);

  /// Distances from `source` to all N vertices into `distances`; infinite where not connected.
  void field(int source, std::span<float> distances);

  /// The vertices within `radius` (inclusive) of `source`, itself included, in order of distance,
  /// ties by index. Cost grows with the ball, not with the mesh. Valid until the next call.
  std::span<const Reached> ball(int source, float radius);

  /// Distance between two vertices; stops as soon as `to` is settled. Infinite if not connected.
  float distance(int from, int to);

 private:
  const GeodesicGraph* graph_;
  std::vector<float> distances_;
  std::vector<Reached> reached_;
};

/// Distances from each of `sources` (rows) to all vertices (columns), row-major, computed in
/// parallel. Memory 4 |sources| N bytes.
std::vector<float> geodesic_fields(const GeodesicGraph& graph, std::span<const int> sources,
                                   const Context& context = {});

}  // namespace isomatch
