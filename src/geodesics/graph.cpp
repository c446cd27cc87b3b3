// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <numeric>

#include "geodesics/visibility.h"
#include "isomatch/error.h"
#include "isomatch/geodesics.h"
#include "isomatch/topology.h"

namespace isomatch {
namespace {

using Arc = GeodesicGraph::Arc;

/// Arcs of a run of vertices, one list after the other, each sorted by head.
struct ArcBlock {
  std::vector<Arc> arcs;
  std::vector<int> ends;  ///< Of the list of each vertex of the run.
};

/// Lists of arcs of all vertices in blocks that can be filled independently of each other.
class ArcBlocks {
 public:
  static constexpr int kVertices = 1024;

  explicit ArcBlocks(int num_vertices)
      : num_vertices_(num_vertices), blocks_((num_vertices + kVertices - 1) / kVertices) {}

  int size() const { return static_cast<int>(blocks_.size()); }
  int first_vertex(int block) const { return block * kVertices; }
  int last_vertex(int block) const { return std::min(num_vertices_, (block + 1) * kVertices); }
  ArcBlock& operator[](int block) { return blocks_[block]; }
  std::span<Arc> list(int vertex) {
    ArcBlock& block = blocks_[vertex / kVertices];
    const int i = vertex % kVertices;
    return {block.arcs.data() + (i == 0 ? 0 : block.ends[i - 1]),
            block.arcs.data() + block.ends[i]};
  }

 private:
  int num_vertices_;
  std::vector<ArcBlock> blocks_;
};

void sort_and_deduplicate(std::vector<Arc>& arcs, std::size_t first) {
  const auto begin = arcs.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, arcs.end(), [](const Arc& a, const Arc& b) {
    return a.head != b.head ? a.head < b.head : a.length < b.length;
  });
  const auto same_head = [](const Arc& a, const Arc& b) { return a.head == b.head; };
  arcs.erase(std::unique(begin, arcs.end(), same_head), arcs.end());
}

ArcBlocks unfold_all(const Mesh& mesh, const GeodesicOptions& options, const Context& context) {
  const IndexLists faces = vertex_faces(mesh);
  const bool edges_only = options.arcs == GeodesicArcs::kEdges;
  const std::vector<std::array<int, 3>> neighbours =
      edges_only ? std::vector(mesh.faces.size(), std::array{kNoFace, kNoFace, kNoFace})
                 : face_neighbours(mesh);
  ArcBlocks blocks(mesh.num_vertices());
#pragma omp parallel num_threads(context.threads) if (blocks.size() > 1)
  {
    StripUnfolder unfolder(mesh, faces, neighbours, options.window_angle);
#pragma omp for schedule(dynamic)
    for (int b = 0; b < blocks.size(); ++b) {
      if (context.stop.stop_requested()) continue;
      ArcBlock& block = blocks[b];
      for (int v = blocks.first_vertex(b); v < blocks.last_vertex(b); ++v) {
        const std::size_t first = block.arcs.size();
        unfolder.append_arcs(v, block.arcs);
        sort_and_deduplicate(block.arcs, first);
        block.ends.push_back(static_cast<int>(block.arcs.size()));
      }
      block.arcs.shrink_to_fit();
    }
  }
  context.check_stop();
  return blocks;
}

/// An arc that was found only from its head's side.
struct MissingArc {
  int tail;
  Arc arc;
};

/// Gives both directions of a line the shorter length. Returns the arcs that lack a reverse, turned
/// round. Pairs are met in the order of their lower end, so that one step forward in the list of
/// the upper end finds the reverse.
std::vector<MissingArc> make_symmetric(ArcBlocks& blocks, int num_vertices) {
  std::vector<MissingArc> missing;
  std::vector<int> next(num_vertices, 0);
  const auto skip_heads_below = [&](int bound, int vertex, std::span<const Arc> arcs) {
    int& i = next[vertex];
    for (; i < std::ssize(arcs) && arcs[i].head < bound; ++i)
      missing.push_back({arcs[i].head, {vertex, arcs[i].length}});
  };
  for (int v = 0; v < num_vertices; ++v) {
    const std::span<Arc> arcs = blocks.list(v);
    skip_heads_below(v, v, arcs);
    for (Arc& arc : arcs.subspan(next[v])) {
      const std::span<Arc> reverse_arcs = blocks.list(arc.head);
      skip_heads_below(v, arc.head, reverse_arcs);
      int& i = next[arc.head];
      if (i < std::ssize(reverse_arcs) && reverse_arcs[i].head == v) {
        arc.length = reverse_arcs[i].length = std::min(arc.length, reverse_arcs[i].length);
        ++i;
      } else {
        missing.push_back({arc.head, {v, arc.length}});
      }
    }
  }
  return missing;
}

/// `arcs` in lists by tail: that of vertex v is [offsets[v], offsets[v + 1]).
struct ArcLists {
  ArcLists(const std::vector<MissingArc>& unsorted, int num_vertices)
      : offsets(num_vertices + 1, 0), arcs(unsorted.size()) {
    for (const MissingArc& m : unsorted) ++offsets[m.tail + 1];
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<std::size_t> end(offsets.begin(), offsets.end() - 1);
    for (const MissingArc& m : unsorted) arcs[end[m.tail]++] = m.arc;
  }
  std::span<const Arc> operator[](int vertex) const {
    return {arcs.data() + offsets[vertex], arcs.data() + offsets[vertex + 1]};
  }

  std::vector<std::size_t> offsets;
  std::vector<Arc> arcs;
};

float mean_edge_length(const Mesh& mesh) {
  double sum = 0;
  for (const Face& face : mesh.faces) {
    for (int corner = 0; corner < 3; ++corner)
      sum += (mesh.vertices[face[corner]] - mesh.vertices[face[(corner + 1) % 3]]).norm();
  }
  return static_cast<float>(sum / (3.0 * mesh.num_faces()));
}

}  // namespace

void GeodesicOptions::validate() const {
  if (!(window_angle > 0 && window_angle <= 60))
    throw InvalidInput("window_angle must be in (0, 60] degrees");
}

GeodesicGraph::GeodesicGraph(const Mesh& mesh, const GeodesicOptions& options,
                             const Context& context) {
  options.validate();
  validate(mesh);
  mean_edge_length_ = isomatch::mean_edge_length(mesh);
  ArcBlocks blocks = unfold_all(mesh, options, context);
  const ArcLists missing(make_symmetric(blocks, mesh.num_vertices()), mesh.num_vertices());

  offsets_.resize(mesh.vertices.size() + 1, 0);
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const std::size_t degree = blocks.list(v).size() + missing[v].size();
    offsets_[v + 1] = offsets_[v] + degree;
    max_degree_ = std::max(max_degree_, static_cast<int>(degree));
  }
  arcs_.resize(offsets_.back());
#pragma omp parallel for schedule(static) num_threads(context.threads) if (blocks.size() > 1)
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    Arc* const first = arcs_.data() + offsets_[v];
    Arc* const middle = std::ranges::copy(blocks.list(v), first).out;
    Arc* const last = std::ranges::copy(missing[v], middle).out;
    if (middle != last)
      std::sort(first, last, [](const Arc& a, const Arc& b) { return a.head < b.head; });
  }
}

}  // namespace isomatch
