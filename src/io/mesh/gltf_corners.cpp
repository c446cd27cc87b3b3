// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/gltf_corners.h"

#include <map>
#include <numeric>
#include <tuple>

namespace isomatch::mesh_io {
namespace {

class Splitter {
 public:
  explicit Splitter(const Model& model) : model_(model), is_placed_(model.mesh.vertices.size()) {
    split_.original.resize(model.mesh.vertices.size());
    std::iota(split_.original.begin(), split_.original.end(), 0);
    split_.coordinates.assign(model.mesh.vertices.size(), Eigen::Vector2d::Zero());
    split_.faces = model.mesh.faces;
  }

  SplitVertices split() {
    for (std::size_t f = 0; f < split_.faces.size(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int coordinate = model_.texture.corners[f][k];
        if (coordinate == Texture::kNone) continue;
        int& vertex = split_.faces[f][k];
        vertex = vertex_at(vertex, model_.texture.coordinates[coordinate]);
      }
    }
    return std::move(split_);
  }

 private:
  /// `vertex` itself or the copy of it that has these coordinates.
  int vertex_at(int vertex, const Eigen::Vector2d& place) {
    if (!is_placed_[vertex]) {
      is_placed_[vertex] = true;
      split_.coordinates[vertex] = place;
    }
    if (split_.coordinates[vertex] == place) return vertex;
    const auto [entry, is_new] = copies_.try_emplace({vertex, place.x(), place.y()},
                                                     static_cast<int>(split_.original.size()));
    if (is_new) {
      split_.original.push_back(vertex);
      split_.coordinates.push_back(place);
    }
    return entry->second;
  }

  const Model& model_;
  std::vector<bool> is_placed_;
  std::map<std::tuple<int, double, double>, int> copies_;
  SplitVertices split_;
};

}  // namespace

SplitVertices split_vertices(const Model& model) {
  if (!model.texture.corners.empty()) return Splitter(model).split();
  SplitVertices split{std::vector<int>(model.mesh.vertices.size()), {}, model.mesh.faces};
  std::iota(split.original.begin(), split.original.end(), 0);
  return split;
}

}  // namespace isomatch::mesh_io
