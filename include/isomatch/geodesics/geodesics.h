// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"

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

  bool operator==(const GeodesicOptions&) const = default;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

/// A straight line to vertex `head`.
struct GeodesicArc {
  int head;
  float length;
};

/// A list of arcs for each vertex. A run of vertices shares a block of memory, so that graphs are
/// built in parallel and without a second copy of all arcs.
class ArcLists {
 public:
  static constexpr int kBlockVertices = 1024;

  /// Arcs of up to `kBlockVertices` vertices; list i is [starts[i], starts[i + 1]).
  struct Block {
    std::vector<GeodesicArc> arcs;
    std::array<int, kBlockVertices + 1> starts{};
  };

  ArcLists() = default;
  /// Empty lists.
  explicit ArcLists(int num_vertices)
      : num_vertices_(num_vertices),
        blocks_((num_vertices + kBlockVertices - 1) / kBlockVertices) {}

  int num_vertices() const { return num_vertices_; }
  std::span<const GeodesicArc> operator[](int vertex) const {
    const auto v = static_cast<unsigned>(vertex);
    const Block& block = blocks_[v / kBlockVertices];
    const int* start = &block.starts[v % kBlockVertices];
    return {block.arcs.data() + start[0], block.arcs.data() + start[1]};
  }
  std::span<GeodesicArc> operator[](int vertex) {
    const auto arcs = std::as_const(*this)[vertex];
    return {const_cast<GeodesicArc*>(arcs.data()), arcs.size()};
  }

  int num_blocks() const { return static_cast<int>(blocks_.size()); }
  Block& block(int index) { return blocks_[index]; }
  const Block& block(int index) const { return blocks_[index]; }
  /// The vertices of a block are [first_vertex, last_vertex).
  int first_vertex(int block) const { return block * kBlockVertices; }
  int last_vertex(int block) const { return std::min(num_vertices_, (block + 1) * kBlockVertices); }

 private:
  int num_vertices_ = 0;
  std::vector<Block> blocks_;
};

/// A graph over the vertices of a mesh whose shortest paths approximate geodesics from above.
/// Lengths are in units of the coordinates. Immutable after construction, safe to share by threads.
class GeodesicGraph {
 public:
  using Arc = GeodesicArc;

  /// Builds the graph; O(N) with about 6 arcs a vertex for `kEdges`, 36 for W20, 80 for W10, of 8
  /// bytes each. Strips stop at boundary and non-manifold edges and after 64 triangles; the
  /// orientation of faces plays no part. Arcs go both ways, are sorted by head and unique, the
  /// shortest of parallel ones. No path is shorter than the geodesic, up to rounding of its sum.
  /// Throws `InvalidInput` if `mesh` fails `validate`.
  explicit GeodesicGraph(const Mesh& mesh, const GeodesicOptions& options = {},
                         const Context& context = {});

  int num_vertices() const { return lists_.num_vertices(); }
  std::size_t num_arcs() const { return num_arcs_; }
  std::span<const Arc> arcs(int vertex) const { return lists_[vertex]; }
  /// Largest number of arcs of a vertex.
  int max_degree() const { return max_degree_; }
  /// Mean length of the mesh's edges, each counted once a face.
  float mean_edge_length() const { return mean_edge_length_; }

 private:
  ArcLists lists_;
  std::size_t num_arcs_ = 0;
  int max_degree_ = 0;
  float mean_edge_length_ = 0;
};

inline constexpr int kNoSource = -1;

/// For each vertex the source that is nearest to it (a Voronoi partition).
struct SourcePartition {
  /// Index into the list of sources, `kNoSource` where none is connected. The lower of equally
  /// near.
  std::vector<int> nearest;
  /// Distance to it, infinite where none is connected.
  std::vector<float> distances;
};

/// Shortest path searches on one graph, with the scratch memory they share: create one per thread.
/// Dijkstra's algorithm on a bucket queue. A distance is a sum of floats along a path, source
/// first, so it is the same to the last bit from every function here; d(a, b) and d(b, a) may
/// differ by rounding.
class GeodesicSearch {
 public:
  struct Reached {
    int vertex;
    float distance;
  };

  /// Keeps a reference to `graph`.
  explicit GeodesicSearch(const GeodesicGraph& graph);
  ~GeodesicSearch();
  GeodesicSearch(GeodesicSearch&&) noexcept;
  GeodesicSearch& operator=(GeodesicSearch&&) noexcept;

  /// Distances from `source` to all N vertices into `distances`; infinite where not connected.
  void field(int source, std::span<float> distances);

  /// Lowers `distances` where `source` is closer: from the distances to the nearest of some sources
  /// (infinite if none) to those with `source` added. Cost grows with the number of vertices that
  /// change, so farthest point sampling costs O(N log N) in all.
  void update_field(int source, std::span<float> distances);

  /// The nearest of `sources` and the distance to it for all vertices, in the time of one field.
  SourcePartition nearest_source(std::span<const int> sources);

  /// The vertices within `radius` (inclusive) of `source`, itself included, in order of distance,
  /// ties by index; never one that is not connected. Cost grows with the ball, not with the mesh.
  /// Valid until the next call.
  std::span<const Reached> ball(int source, float radius);

  /// Distance between two vertices; stops as soon as `to` is settled. Infinite if not connected.
  float distance(int from, int to);

 private:
  struct Queue;

  template <class Improves, class Accept>
  void propagate(std::span<const float> distances, const float& limit, const Improves& improves,
                 const Accept& accept);
  void collect(int source, const float& limit);

  const GeodesicGraph* graph_;
  std::unique_ptr<Queue> queue_;
  std::vector<float> distances_;
  std::vector<Reached> reached_;
  std::vector<Reached> improved_;  ///< Scratch for the arcs of one vertex.
};

/// Distances from each of `sources` (rows) to all vertices (columns), row-major, computed in
/// parallel. Memory 4 |sources| N bytes, and 69 N a thread meanwhile.
std::vector<float> geodesic_fields(const GeodesicGraph& graph, std::span<const int> sources,
                                   const Context& context = {});

/// At most `count` places in `candidates` (vertices, not empty), evenly spread: the place `first`,
/// then always the farthest from those before it; ends early when all have been taken. Ties go to
/// the earlier place. O(N log N).
std::vector<int> farthest_points(const GeodesicGraph& graph, std::span<const int> candidates,
                                 int count, int first = 0, const Context& context = {});

/// The largest geodesic distance between two connected vertices, approximated from below: exact to
/// .5 % or the best of 49 fields, whichever comes first. Fields are taken from the vertices that
/// the triangle inequality still lets be the most eccentric, so it ends after 15 to 40 fields on
/// shapes with limbs and is exact on most of them. O(N log N), in parallel, two fields at a time.
double geodesic_diameter(const GeodesicGraph& graph, const Context& context = {});

}  // namespace isomatch
