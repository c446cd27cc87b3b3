// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "geometry/handle_loop.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kHole = -1;

int num_components_with_faces(const Mesh& mesh) {
  const std::vector<int> label = vertex_components(mesh);
  std::vector<bool> seen(mesh.vertices.size(), false);
  int count = 0;
  for (const Face& face : mesh.faces) {
    if (!seen[label[face[0]]]) ++count;
    seen[label[face[0]]] = true;
  }
  return count;
}

int num_used_vertices(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Face& face : mesh.faces)
    for (int v : face) used[v] = true;
  return static_cast<int>(std::ranges::count(used, true));
}

}  // namespace

struct HandleLoops::Tree {
  std::vector<double> distance;
  /// The edge towards the root, -1 at the root and where nothing leads.
  std::vector<int> up;
};

HandleLoops::HandleLoops(const Mesh& mesh, std::span<const double> weights)
    : num_vertices_(mesh.num_vertices()), num_sides_(mesh.num_faces()) {
  bool manifold = true;
  DisjointSets rims(mesh.num_vertices());
  for_each_edge(sorted_edge_sides(mesh), [&](std::span<const EdgeSide> sides) {
    const int a = sides[0].low, b = sides[0].high;
    const double length = (mesh.vertices[a] - mesh.vertices[b]).norm();
    const bool rim = sides.size() == 1;
    manifold = manifold && sides.size() <= 2;
    edges_.push_back(
        {a, b, sides[0].face, rim ? kHole : sides[1].face, length * (weights[a] + weights[b]) / 2});
    if (rim) rims.join(a, b);
  });
  std::map<int, int> hole_at;
  for (Edge& edge : edges_) {
    if (edge.right != kHole) continue;
    const auto [hole, is_new] = hole_at.try_emplace(rims.find(edge.a), num_sides_);
    num_sides_ += is_new ? 1 : 0;
    edge.right = hole->second;
  }
  const int euler = num_used_vertices(mesh) - static_cast<int>(edges_.size()) + num_sides_;
  if (manifold) num_handles_ = std::max(0, num_components_with_faces(mesh) - euler / 2);

  offsets_.assign(num_vertices_ + 1, 0);
  for (const Edge& edge : edges_) {
    ++offsets_[edge.a + 1];
    ++offsets_[edge.b + 1];
  }
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  halves_.resize(offsets_.back());
  std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
  for (int e = 0; std::cmp_less(e, edges_.size()); ++e) {
    halves_[next[edges_[e].a]++] = {edges_[e].b, e};
    halves_[next[edges_[e].b]++] = {edges_[e].a, e};
  }
}

HandleLoops::Tree HandleLoops::shortest_paths(int root) const {
  Tree tree{std::vector<double>(num_vertices_, kInfinite), std::vector<int>(num_vertices_, -1)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  tree.distance[root] = 0;
  open.emplace(0, root);
  while (!open.empty()) {
    const auto [distance, v] = open.top();
    open.pop();
    if (distance > tree.distance[v]) continue;
    for (int h = offsets_[v]; h < offsets_[v + 1]; ++h) {
      const auto [to, edge] = halves_[h];
      const double further = distance + edges_[edge].cost;
      if (further >= tree.distance[to]) continue;
      tree.distance[to] = further;
      tree.up[to] = edge;
      open.emplace(further, to);
    }
  }
  return tree;
}

/// Those of the edges that are neither in the tree nor in the tree of faces that crosses what is
/// left, the longest ways round first.
std::vector<int> HandleLoops::crossing_edges(const Tree& tree) const {
  std::vector<int> left;
  const auto way = [&](int e) {
    return tree.distance[edges_[e].a] + tree.distance[edges_[e].b] + edges_[e].cost;
  };
  for (int e = 0; std::cmp_less(e, edges_.size()); ++e) {
    const auto [a, b, l, r, cost] = edges_[e];
    if (std::isfinite(tree.distance[a]) && tree.up[a] != e && tree.up[b] != e) left.push_back(e);
  }
  std::ranges::stable_sort(left, std::greater(), way);
  DisjointSets sides(num_sides_);
  std::erase_if(left, [&](int e) {
    const int l = sides.find(edges_[e].left), r = sides.find(edges_[e].right);
    sides.join(l, r);
    return l != r;
  });
  return left;
}

/// From where the ways to both ends of an edge part.
HandleLoops::Loop HandleLoops::loop_through(const Tree& tree, const Edge& edge) const {
  const auto way_up = [&](int v) {
    std::vector<int> way{v};
    for (int e = tree.up[v]; e != -1; e = tree.up[v]) {
      v = edges_[e].a == v ? edges_[e].b : edges_[e].a;
      way.push_back(v);
    }
    return way;
  };
  std::vector<int> one = way_up(edge.a), other = way_up(edge.b);
  int parting = one.back();
  while (!one.empty() && !other.empty() && one.back() == other.back()) {
    parting = one.back();
    one.pop_back();
    other.pop_back();
  }
  Loop loop{std::move(one),
            tree.distance[edge.a] + tree.distance[edge.b] + edge.cost - 2 * tree.distance[parting]};
  loop.vertices.push_back(parting);
  loop.vertices.insert(loop.vertices.end(), other.rbegin(), other.rend());
  return loop;
}

HandleLoops::Loop HandleLoops::cheapest(std::span<const int> roots) const {
  Loop best{{}, kInfinite};
  for (const int root : roots) {
    const Tree tree = shortest_paths(root);
    for (const int e : crossing_edges(tree)) {
      Loop loop = loop_through(tree, edges_[e]);
      if (loop.cost < best.cost) best = std::move(loop);
    }
  }
  return best;
}

}  // namespace isomatch
