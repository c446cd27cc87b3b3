// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <ranges>
#include <utility>

#include "geodesics/visibility.h"
#include "isomatch/error.h"
#include "isomatch/geodesics/geodesics.h"
#include "isomatch/mesh/topology.h"
#include "parallel.h"

namespace isomatch {
namespace {

using Arc = GeodesicArc;

void sort_and_deduplicate(std::vector<Arc>& arcs, std::ptrdiff_t first) {
  const auto begin = arcs.begin() + first;
  std::sort(begin, arcs.end(), [](const Arc& a, const Arc& b) {
    return a.head != b.head ? a.head < b.head : a.length < b.length;
  });
  const auto same_head = [](const Arc& a, const Arc& b) { return a.head == b.head; };
  arcs.erase(std::unique(begin, arcs.end(), same_head), arcs.end());
}

/// `arcs` is scratch.
void unfold_block(StripUnfolder& unfolder, int first_vertex, int last_vertex,
                  std::vector<Arc>& arcs, ArcLists::Block& block) {
  arcs.clear();
  for (int v = first_vertex, i = 0; v < last_vertex; ++v) {
    unfolder.append_arcs(v, arcs);
    sort_and_deduplicate(arcs, block.starts[i]);
    block.starts[++i] = static_cast<int>(arcs.size());
  }
  block.arcs = arcs;
}

/// What each vertex sees, sorted by head.
ArcLists unfold_all(const Mesh& mesh, const GeodesicOptions& options, const Context& context) {
  const IndexLists faces = vertex_faces(mesh);
  const bool edges_only = options.arcs == GeodesicArcs::kEdges;
  const std::vector<std::array<int, 3>> neighbours =
      edges_only ? std::vector(mesh.faces.size(), std::array{kNoFace, kNoFace, kNoFace})
                 : face_neighbours(mesh);
  ArcLists lists(mesh.num_vertices());
  struct Work {
    StripUnfolder unfolder;
    std::vector<Arc> arcs;
  };
  const auto make = [&] {
    return Work{StripUnfolder(mesh, faces, neighbours, options.window_angle), {}};
  };
  parallel_for(lists.num_blocks(), context, make, [&](Work& work, std::ptrdiff_t i) {
    const int b = static_cast<int>(i);
    unfold_block(work.unfolder, lists.first_vertex(b), lists.last_vertex(b), work.arcs,
                 lists.block(b));
  });
  return lists;
}

/// An arc that was found only from its head's side.
struct MissingArc {
  int tail;
  Arc arc;
};

/// By the block of their tails.
using MissingArcs = std::vector<std::vector<MissingArc>>;

/// Gives both directions of a line the shorter length. Returns the arcs that lack a reverse, turned
/// round. Pairs are met in the order of their lower end, so that one step forward in the list of
/// the upper end finds the reverse.
MissingArcs make_symmetric(ArcLists& lists) {
  MissingArcs missing(lists.num_blocks());
  const auto add_missing = [&](int tail, const Arc& arc) {
    missing[tail / ArcLists::kBlockVertices].push_back({tail, arc});
  };
  std::vector<int> next(lists.num_vertices(), 0);
  const auto skip_heads_below = [&](int bound, int vertex) {
    const std::span<Arc> arcs = lists[vertex];
    int& i = next[vertex];
    for (; i < std::ssize(arcs) && arcs[i].head < bound; ++i)
      add_missing(arcs[i].head, {vertex, arcs[i].length});
    return arcs.subspan(i);
  };
  for (int v = 0; v < lists.num_vertices(); ++v) {
    for (Arc& arc : skip_heads_below(v, v)) {
      const std::span<Arc> reverse = skip_heads_below(v, arc.head);
      if (!reverse.empty() && reverse[0].head == v) {
        arc.length = reverse[0].length = std::min(arc.length, reverse[0].length);
        ++next[arc.head];
      } else {
        add_missing(arc.head, {v, arc.length});
      }
    }
  }
  return missing;
}

/// Merges `missing`, the missing arcs of the vertices of a block, into their lists.
void add_missing_arcs(std::vector<MissingArc> missing, int first_vertex, int last_vertex,
                      ArcLists::Block& block) {
  std::ranges::sort(missing, [](const MissingArc& a, const MissingArc& b) {
    return a.tail != b.tail ? a.tail < b.tail : a.arc.head < b.arc.head;
  });
  std::vector<Arc> merged;
  merged.reserve(block.arcs.size() + missing.size());
  auto first_missing = missing.begin();
  int start = 0;
  for (int i = 0; i < last_vertex - first_vertex; ++i) {
    const auto last_missing =
        std::find_if_not(first_missing, missing.end(),
                         [&](const MissingArc& m) { return m.tail == first_vertex + i; });
    const int end = block.starts[i + 1];
    std::ranges::merge(std::span(block.arcs).subspan(start, end - start),
                       std::ranges::subrange(first_missing, last_missing) |
                           std::views::transform(&MissingArc::arc),
                       std::back_inserter(merged), {}, &Arc::head, &Arc::head);
    block.starts[i + 1] = static_cast<int>(merged.size());
    first_missing = last_missing;
    start = end;
  }
  block.arcs = std::move(merged);
}

/// Throws `InvalidInput` if distances would not fit into 32 bits.
float mean_edge_length(const Mesh& mesh) {
  constexpr double kShortest = 1e-30, kLongest = 1e30;
  double sum = 0, longest = 0;
  for (const Face& face : mesh.faces) {
    for (int corner = 0; corner < 3; ++corner) {
      const double length =
          (mesh.vertices[face[corner]] - mesh.vertices[face[(corner + 1) % 3]]).norm();
      sum += length;
      longest = std::max(longest, length);
    }
  }
  const double mean = sum / (3.0 * mesh.num_faces());
  const bool is_point = longest == 0;
  if (!is_point && !(mean >= kShortest && longest <= kLongest))
    throw InvalidInput(fmt::format(
        "edges are {:.3g} long on average and {:.3g} at most; geodesic distances need lengths "
        "between {:g} and {:g}",
        mean, longest, kShortest, kLongest));
  return static_cast<float>(mean);
}

}  // namespace

void GeodesicOptions::validate() const {
  if (!(window_angle > 0 && window_angle <= 60))
    throw InvalidInput("window_angle must be in (0, 60] degrees");
}

GeodesicGraph::GeodesicGraph(const Mesh& mesh, const GeodesicOptions& options,
                             const Context& context) {
  options.validate();
  validate_finite(mesh);
  mean_edge_length_ = isomatch::mean_edge_length(mesh);
  lists_ = unfold_all(mesh, options, context);
  MissingArcs missing = make_symmetric(lists_);
  parallel_for(lists_.num_blocks(), context, [&](std::ptrdiff_t i) {
    const int b = static_cast<int>(i);
    add_missing_arcs(std::exchange(missing[b], {}), lists_.first_vertex(b), lists_.last_vertex(b),
                     lists_.block(b));
  });

  for (int b = 0; b < lists_.num_blocks(); ++b) num_arcs_ += lists_.block(b).arcs.size();
  for (int v = 0; v < num_vertices(); ++v)
    max_degree_ = std::max(max_degree_, static_cast<int>(arcs(v).size()));
}

}  // namespace isomatch
