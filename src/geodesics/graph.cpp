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
  std::span<const Arc> list(int vertex) const {
    const ArcBlock& block = blocks_[vertex / kVertices];
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

/// The arc to `head` in a list sorted by head, or null.
const Arc* find_arc(std::span<const Arc> arcs, int head) {
  const auto arc = std::ranges::lower_bound(arcs, head, {}, &Arc::head);
  return arc != arcs.end() && arc->head == head ? &*arc : nullptr;
}

/// An arc that was found only from its head's side.
struct MissingArc {
  int tail;
  Arc arc;
};

std::vector<MissingArc> missing_arcs(ArcBlocks& blocks, const Context& context) {
  std::vector<std::vector<MissingArc>> missing(blocks.size());
#pragma omp parallel for schedule(dynamic) num_threads(context.threads) if (blocks.size() > 1)
  for (int b = 0; b < blocks.size(); ++b) {
    for (int v = blocks.first_vertex(b); v < blocks.last_vertex(b); ++v) {
      for (const Arc& arc : blocks.list(v))
        if (!find_arc(blocks.list(arc.head), v)) missing[b].push_back({arc.head, {v, arc.length}});
    }
  }
  std::vector<MissingArc> all;
  for (auto& block : missing) {
    all.insert(all.end(), block.begin(), block.end());
    block = {};
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const MissingArc& a, const MissingArc& b) { return a.tail < b.tail; });
  return all;
}

/// Per vertex, where its arcs of `missing` start; one more entry than there are vertices.
std::vector<std::size_t> starts_by_tail(const std::vector<MissingArc>& missing, int num_vertices) {
  std::vector<std::size_t> starts(num_vertices + 1, 0);
  for (const MissingArc& m : missing) ++starts[m.tail + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  return starts;
}

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
  const std::vector<MissingArc> missing = missing_arcs(blocks, context);
  const std::vector<std::size_t> starts = starts_by_tail(missing, mesh.num_vertices());

  offsets_.resize(mesh.vertices.size() + 1, 0);
  for (int v = 0; v < mesh.num_vertices(); ++v)
    offsets_[v + 1] = offsets_[v] + blocks.list(v).size() + starts[v + 1] - starts[v];
  arcs_.resize(offsets_.back());
#pragma omp parallel for schedule(dynamic, ArcBlocks::kVertices) num_threads(context.threads)
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    auto out = arcs_.begin() + static_cast<std::ptrdiff_t>(offsets_[v]);
    std::size_t m = starts[v];
    for (const Arc& arc : blocks.list(v)) {
      while (m < starts[v + 1] && missing[m].arc.head < arc.head) *out++ = missing[m++].arc;
      const Arc* reverse = find_arc(blocks.list(arc.head), v);
      *out++ = {arc.head, reverse ? std::min(arc.length, reverse->length) : arc.length};
    }
    while (m < starts[v + 1]) *out++ = missing[m++].arc;
  }
}

}  // namespace isomatch
