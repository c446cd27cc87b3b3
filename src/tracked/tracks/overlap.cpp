// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/overlap.h"

#include <algorithm>
#include <array>

#include "geometry/disjoint_sets.h"
#include "geometry/kd_tree.h"
#include "geometry/rotation.h"

namespace isomatch::tracked {
namespace {

/// Connected pieces of those that are, or are not, inside.
DisjointSets pieces_of(const std::vector<bool>& inside, bool which, const IndexLists& neighbours) {
  DisjointSets pieces(neighbours.size());
  for (int i = 0; i < neighbours.size(); ++i)
    for (int j : neighbours[i])
      if (inside[i] == which && inside[j] == which) pieces.join(i, j);
  return pieces;
}

/// Without the pieces that are smaller than a share of all.
void drop_small_pieces(const std::vector<double>& areas, const IndexLists& neighbours, double share,
                       std::vector<bool>& inside) {
  DisjointSets pieces = pieces_of(inside, true, neighbours);
  std::vector<double> area(inside.size(), 0.0);
  double total = 0;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (!inside[i]) continue;
    area[pieces.find(static_cast<int>(i))] += areas[i];
    total += areas[i];
  }
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (area[pieces.find(static_cast<int>(i))] < share * total) inside[i] = false;
}

/// Samples of a part at nodes, of those nodes that have a row.
struct PartSamples {
  spectral::Samples samples;
  /// Node of each sample, and the sample of each node, -1 where it has none.
  std::vector<int> node, sample;
};

PartSamples samples_of(const Part& part, const Proxy& proxy, const Level& level) {
  PartSamples result;
  result.sample.assign(level.size(), -1);
  for (int i = 0; i < level.size(); ++i) {
    if (part.row[proxy.nodes[i]] == kNoVertex) continue;
    result.sample[i] = static_cast<int>(result.node.size());
    result.node.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(result.node.size());
  result.samples.functions.resize(n, part.basis.functions.cols());
  result.samples.areas.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    result.samples.functions.row(k) =
        part.basis.functions.row(part.row[proxy.nodes[result.node[k]]]);
    result.samples.areas[k] = static_cast<float>(level.graph.cloud.areas[result.node[k]]);
  }
  return result;
}

}  // namespace

void carry_outside(const elastic::PointCloud& cloud, std::vector<Point>& anchors) {
  constexpr std::size_t kAround = 24;  // Enough that rotation about a limb is determined.
  std::vector<int> inside;
  std::vector<Point> rest;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (!cloud.is_inside(static_cast<int>(i))) continue;
    inside.push_back(static_cast<int>(i));
    rest.push_back(cloud.positions[i]);
  }
  if (rest.empty()) return;
  const KdTree<3> tree(rest);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (cloud.is_inside(static_cast<int>(i))) continue;
    std::array<int, kAround> nearest{};
    const std::size_t count = tree.nearest(cloud.positions[i], nearest);
    std::vector<Point> from, to;
    for (std::size_t k = 0; k < count; ++k) {
      from.push_back(rest[nearest[k]]);
      to.push_back(anchors[inside[nearest[k]]]);
    }
    anchors[i] = best_rotation(from, to) * (cloud.positions[i] - mean_of(from)) + mean_of(to);
  }
}

std::vector<bool> smoothed(const std::vector<bool>& inside, const std::vector<double>& areas,
                           const IndexLists& neighbours, const PartialOptions& options) {
  std::vector<float> share(inside.begin(), inside.end());
  for (int step = 0; step < options.smoothing; ++step) {
    std::vector<float> next(share);
    for (int i = 0; i < neighbours.size(); ++i) {
      if (neighbours[i].empty()) continue;
      float sum = 0;
      for (int j : neighbours[i]) sum += share[j];
      next[i] = 0.5F * (share[i] + sum / static_cast<float>(neighbours[i].size()));
    }
    share = std::move(next);
  }
  std::vector<bool> result(share.size());
  for (std::size_t i = 0; i < share.size(); ++i) result[i] = share[i] >= 0.5F;
  drop_small_pieces(areas, neighbours, options.min_piece, result);
  return result;
}

std::vector<bool> inside_after(const elastic::PointCloud& cloud, const IndexLists& neighbours,
                               const elastic::Registration& registration, const Options& options) {
  if (cloud.inside.empty()) return {};
  std::vector<bool> inside = registration.met;
  for (int i = 0; i < neighbours.size(); ++i)
    inside[i] = inside[i] && (cloud.inside[i] || std::ranges::any_of(neighbours[i], [&](int j) {
                                return cloud.inside[j];
                              }));
  return smoothed(inside, cloud.areas, neighbours, options.partial);
}

double left_out(const Coverage& nodes, const PartialOptions& options) {
  DisjointSets pieces = pieces_of(nodes.inside, false, nodes.neighbours);
  struct Piece {
    double area = 0;
    int border = 0, by_rim = 0;
  };
  std::vector<Piece> sums(nodes.inside.size());
  for (int i = 0; i < nodes.neighbours.size(); ++i) {
    if (nodes.inside[i]) continue;
    Piece& piece = sums[pieces.find(i)];
    piece.area += nodes.areas[i];
    if (std::ranges::none_of(nodes.neighbours[i], [&](int j) { return nodes.inside[j]; })) continue;
    ++piece.border;
    if (nodes.by_rim[i]) ++piece.by_rim;
  }
  double price = 0;
  for (const Piece& piece : sums) {
    const double explained =
        piece.border == 0 ? 0 : static_cast<double>(piece.by_rim) / piece.border;
    price += piece.area * (explained + (1 - explained) * options.contradiction_price);
  }
  return price;
}

std::vector<bool> feet_by_rim(const elastic::Registration& registration, const Proxy& target,
                              const PartialOptions& options) {
  std::vector<bool> by_rim;
  for (const elastic::Foot& foot : registration.feet)
    by_rim.push_back(std::ranges::any_of(target.mesh.faces[foot.point.face], [&](int v) {
      return target.to_boundary[v] < options.rim_width;
    }));
  return by_rim;
}

Part part_of_proxy(const Proxy& proxy, const Level& level, const std::vector<bool>& inside,
                   int functions, const Context& context) {
  constexpr int kFewest = 20;
  Part part;
  part.row.assign(proxy.num_vertices(), kNoVertex);
  Mesh mesh;
  const auto number = [&](int vertex) {
    if (part.row[vertex] == kNoVertex) {
      part.row[vertex] = mesh.num_vertices();
      part.vertex.push_back(vertex);
      mesh.vertices.push_back(proxy.mesh.vertices[vertex]);
    }
    return part.row[vertex];
  };
  for (const Face& face : proxy.mesh.faces) {
    const bool within =
        std::ranges::all_of(face, [&](int v) { return inside[level.graph.cell[v]]; });
    if (within) mesh.faces.push_back({number(face[0]), number(face[1]), number(face[2])});
  }
  if (mesh.num_vertices() < kFewest) return {{}, {}, std::vector<int>(proxy.num_vertices(), -1)};
  part.basis = spectral::eigenbasis(mesh, functions, context);
  return part;
}

std::vector<int> refine_on_overlap(const Overlap& overlap, const Proxy& source, const Proxy& target,
                                   const NodeMap& map, const Level& wanted, int size,
                                   const Context& context) {
  PartSamples from = samples_of(overlap.source, source, map.source);
  PartSamples onto = samples_of(overlap.target, target, map.target);
  std::vector<int> forth(from.node.size(), 0), back(onto.node.size(), 0);
  for (std::size_t k = 0; k < from.node.size(); ++k) {
    const int row = overlap.target.row[map.vertices[from.node[k]]];
    if (row == kNoVertex || !map.source_inside[from.node[k]])
      from.samples.areas[static_cast<Eigen::Index>(k)] = 0;
    else
      forth[k] = row;
  }
  for (std::size_t k = 0; k < onto.node.size(); ++k) {
    const int sample = from.sample[map.nearest[onto.node[k]]];
    if (sample < 0)
      onto.samples.areas[static_cast<Eigen::Index>(k)] = 0;
    else
      back[k] = sample;
  }
  const PartSamples goal = samples_of(overlap.source, source, wanted);
  const std::vector<int> rows =
      spectral::refine(from.samples, onto.samples, overlap.target.basis,
                       {std::move(forth), std::move(back)}, goal.samples, size, context);
  std::vector<int> vertices(wanted.size(), kNoVertex);
  for (std::size_t k = 0; k < rows.size(); ++k)
    vertices[goal.node[k]] = overlap.target.vertex[rows[k]];
  return vertices;
}

}  // namespace isomatch::tracked
