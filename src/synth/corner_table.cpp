// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/corner_table.h"

#include <algorithm>

#include "isomatch/mesh/topology.h"

namespace isomatch::synth {
namespace {

int corner_towards(const std::array<int, 3>& neighbours, int face) {
  return static_cast<int>(std::find(neighbours.begin(), neighbours.end(), face) -
                          neighbours.begin());
}

}  // namespace

CornerTable::CornerTable(const Mesh& mesh)
    : corner_(mesh.vertices.size(), -1), live_vertices_(mesh.num_vertices()) {
  const auto neighbours = face_neighbours(mesh);
  vertex_.reserve(3 * mesh.faces.size());
  for (const Face& face : mesh.faces) add_face(face);
  for (int c = 0; c < num_corners(); ++c) {
    const int across = neighbours[c / 3][c % 3];
    opposite_[c] = 3 * across + corner_towards(neighbours[across], c / 3);
  }
}

void CornerTable::link(int a, int b) {
  opposite_[a] = b;
  opposite_[b] = a;
}

int CornerTable::add_face(const Face& face) {
  const int first = num_corners();
  for (int i = 0; i < 3; ++i) {
    vertex_.push_back(face[i]);
    opposite_.push_back(-1);
    corner_[face[i]] = first + i;
  }
  return first;
}

void CornerTable::remove_face_of(int corner) {
  const int first = corner - corner % 3;
  for (int i = 0; i < 3; ++i) vertex_[first + i] = opposite_[first + i] = -1;
}

bool CornerTable::adjacent(int a, int b) const {
  bool found = false;
  around(a, [&](int c) { found |= vertex_[next(c)] == b; });
  return found;
}

bool CornerTable::flip(int corner) {
  const int c = corner, o = opposite_[c];
  const int a = vertex_[c], b = vertex_[o], u = from(c), v = to(c);
  if (adjacent(a, b)) return false;
  const int va = opposite_[next(c)], ub = opposite_[next(o)];
  // The faces (a, u, v) and (b, v, u) become (a, u, b) and (b, v, a).
  vertex_[previous(c)] = b;
  vertex_[previous(o)] = a;
  link(c, ub);
  link(o, va);
  link(next(c), next(o));
  corner_[a] = c;
  corner_[b] = o;
  corner_[u] = next(c);
  corner_[v] = next(o);
  return true;
}

int CornerTable::split(int corner) {
  const int c = corner, o = opposite_[c];
  const int a = vertex_[c], b = vertex_[o], v = to(c);
  const int va = opposite_[next(c)], bv = opposite_[previous(o)];
  const int middle = num_vertices();
  corner_.push_back(-1);
  ++live_vertices_;
  const int f = add_face({a, middle, v}), g = add_face({b, v, middle});
  vertex_[previous(c)] = middle;
  vertex_[next(o)] = middle;
  link(f, g);
  link(f + 1, va);
  link(f + 2, next(c));
  link(g + 1, previous(o));
  link(g + 2, bv);
  return middle;
}

bool CornerTable::can_collapse(int corner) const {
  const int a = vertex_[corner], b = vertex_[opposite_[corner]];
  const int u = from(corner), v = to(corner);
  for (int apex : {a, b}) {
    int valence = 0;
    around(apex, [&](int) { ++valence; });
    if (valence <= 3) return false;
  }
  bool pinches = false;
  around(u, [&](int c) {
    const int w = vertex_[next(c)];
    if (w != a && w != b && w != v) pinches |= adjacent(w, v);
  });
  return !pinches;
}

void CornerTable::collapse(int corner) {
  const int c = corner, o = opposite_[c];
  const int a = vertex_[c], b = vertex_[o], u = from(c), v = to(c);
  const int va = opposite_[next(c)], au = opposite_[previous(c)];
  const int ub = opposite_[next(o)], bv = opposite_[previous(o)];
  // Renaming while swinging would lose no corner, as swing() follows faces, not names.
  around(v, [&](int at_v) { vertex_[at_v] = u; });
  link(va, au);
  link(ub, bv);
  remove_face_of(c);
  remove_face_of(o);
  corner_[a] = next(va);
  corner_[b] = next(ub);
  corner_[u] = previous(va);
  corner_[v] = -1;
  --live_vertices_;
}

std::vector<std::array<int, 2>> CornerTable::subdivide() {
  std::vector<std::array<int, 2>> ends;
  std::vector<int> middle(num_corners());
  for (int c = 0; c < num_corners(); ++c) {
    middle[c] =
        opposite_[c] < c ? middle[opposite_[c]] : num_vertices() + static_cast<int>(ends.size());
    if (opposite_[c] > c) ends.push_back({from(c), to(c)});
  }
  const std::vector<int> old_vertex = std::move(vertex_), old_opposite = std::move(opposite_);
  live_vertices_ += static_cast<int>(ends.size());
  corner_.assign(live_vertices_, -1);
  vertex_.clear();
  opposite_.clear();
  vertex_.reserve(4 * old_vertex.size());
  opposite_.reserve(4 * old_vertex.size());
  // Of face f's children, 4 f + i keeps corner i and 4 f + 3 lies in the middle.
  for (int c = 0; c < static_cast<int>(old_vertex.size()); ++c) {
    add_face({old_vertex[c], middle[previous(c)], middle[next(c)]});
    if (c % 3 == 2) add_face({middle[c - 2], middle[c - 1], middle[c]});
  }
  const auto child = [](int c) { return 3 * (c + c / 3); };
  for (int c = 0; c < static_cast<int>(old_vertex.size()); ++c) {
    link(child(c), 12 * (c / 3) + 9 + c % 3);
    // The half edge from c towards previous(c), seen from the face across it.
    opposite_[child(c) + 1] = child(next(old_opposite[next(c)])) + 2;
    opposite_[child(c) + 2] = child(previous(old_opposite[previous(c)])) + 1;
  }
  return ends;
}

std::vector<int> CornerTable::compact() {
  std::vector<int> old_index, new_index(num_vertices(), -1);
  for (int v = 0; v < num_vertices(); ++v) {
    if (corner_[v] < 0) continue;
    new_index[v] = static_cast<int>(old_index.size());
    old_index.push_back(v);
  }
  std::vector<int> new_first(num_corners() / 3);
  int kept = 0;
  for (int c = 0; c < num_corners(); c += 3) {
    new_first[c / 3] = kept;
    if (is_live(c)) kept += 3;
  }
  corner_.assign(old_index.size(), -1);
  for (int c = 0; c < num_corners(); ++c) {
    if (!is_live(c)) continue;
    const int to = new_first[c / 3] + c % 3, across = opposite_[c];
    vertex_[to] = new_index[vertex_[c]];
    opposite_[to] = new_first[across / 3] + across % 3;
    corner_[vertex_[to]] = to;
  }
  vertex_.resize(kept);
  opposite_.resize(kept);
  return old_index;
}

std::vector<Face> CornerTable::faces() const {
  std::vector<Face> faces(num_corners() / 3);
  for (int c = 0; c < num_corners(); ++c) faces[c / 3][c % 3] = vertex_[c];
  return faces;
}

}  // namespace isomatch::synth
