// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/gltf_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "isomatch/mesh/mesh.h"

namespace isomatch::mesh_io {
namespace {

/// The first `size` of `numbers`; without any, `otherwise`.
template <std::size_t size>
std::array<double, size> numbers_or(const std::vector<double>& numbers,
                                    std::array<double, size> otherwise) {
  if (numbers.size() >= size) std::copy_n(numbers.begin(), size, otherwise.begin());
  return otherwise;
}

Eigen::Affine3d local_transform(const tinygltf::Node& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) transform.matrix()(i % 4, i / 4) = node.matrix[i];
    return transform;
  }
  const auto t = numbers_or<3>(node.translation, {0, 0, 0});
  const auto r = numbers_or<4>(node.rotation, {0, 0, 0, 1});
  const auto s = numbers_or<3>(node.scale, {1, 1, 1});
  return transform.translate(Point(t[0], t[1], t[2]))
      .rotate(Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized())
      .scale(Point(s[0], s[1], s[2]));
}

template <class Element>
const Element& element(const InputFile& file, const std::vector<Element>& list, int index,
                       std::string_view name) {
  if (index < 0 || index >= std::ssize(list))
    file.fail(fmt::format("{} {} is out of range, there are {}", name, index, list.size()));
  return list[index];
}

PlacedMesh place(const tinygltf::Model& model, const tinygltf::Mesh& mesh,
                 const tinygltf::Node* node, const Eigen::Affine3d& transform) {
  std::string name = node ? node->name : "";
  if (name.empty()) name = mesh.name;
  if (name.empty()) name = fmt::format("mesh_{}", &mesh - model.meshes.data());
  return {&mesh, transform, std::move(name)};
}

/// Walks the nodes of one scene.
class SceneWalk {
 public:
  SceneWalk(const InputFile& file, const tinygltf::Model& model)
      : file_(file), model_(model), visited_(model.nodes.size(), false) {}

  void visit(const std::vector<int>& nodes, const Eigen::Affine3d& parent, int depth) {
    constexpr int kDeepest = 500;
    if (depth > kDeepest) file_.fail("its nodes are nested too deeply");
    for (const int index : nodes) {
      const tinygltf::Node& node = element(file_, model_.nodes, index, "node");
      if (visited_[index]) file_.fail(fmt::format("node {} has two parents", index));
      visited_[index] = true;
      const Eigen::Affine3d transform = parent * local_transform(node);
      if (node.mesh >= 0) add(node, transform);
      visit(node.children, transform, depth + 1);
    }
  }

  std::vector<PlacedMesh> placed;

 private:
  void add(const tinygltf::Node& node, const Eigen::Affine3d& transform) {
    const tinygltf::Mesh& mesh = element(file_, model_.meshes, node.mesh, "mesh");
    // By the specification only a skin's joints move it.
    const Eigen::Affine3d unmoved = Eigen::Affine3d::Identity();
    placed.push_back(place(model_, mesh, &node, node.skin >= 0 ? unmoved : transform));
  }

  const InputFile& file_;
  const tinygltf::Model& model_;
  std::vector<bool> visited_;
};

/// A file without scenes may have nodes all the same.
std::vector<int> root_nodes(const InputFile& file, const tinygltf::Model& model) {
  if (!model.scenes.empty())
    return element(file, model.scenes, std::max(model.defaultScene, 0), "scene").nodes;
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children)
      if (child >= 0 && child < std::ssize(is_child)) is_child[child] = true;
  std::vector<int> roots;
  for (std::size_t n = 0; n < is_child.size(); ++n)
    if (!is_child[n]) roots.push_back(static_cast<int>(n));
  return roots;
}

}  // namespace

std::vector<PlacedMesh> placed_meshes(const InputFile& file, const tinygltf::Model& model) {
  SceneWalk walk(file, model);
  walk.visit(root_nodes(file, model), Eigen::Affine3d::Identity(), 0);
  if (walk.placed.empty()) walk.placed = meshes_outside(model, {});
  if (walk.placed.empty()) file.fail("has no mesh");
  return walk.placed;
}

std::vector<PlacedMesh> named_meshes(const InputFile& file, const std::vector<PlacedMesh>& placed,
                                     const std::string& name) {
  std::vector<PlacedMesh> named;
  std::ranges::copy_if(placed, std::back_inserter(named), [&](const PlacedMesh& candidate) {
    return candidate.name == name || candidate.mesh->name == name;
  });
  if (named.empty())
    file.fail(fmt::format("has no mesh {}, only {}", in_quotes(name), listed_names(placed)));
  return named;
}

std::string listed_names(const std::vector<PlacedMesh>& meshes) {
  constexpr std::size_t kMost = 8;
  std::string list;
  for (std::size_t k = 0; k < std::min(meshes.size(), kMost); ++k)
    list += (k == 0 ? "" : ", ") + in_quotes(meshes[k].name);
  if (meshes.size() > kMost) list += fmt::format(" and {} more", meshes.size() - kMost);
  return list;
}

std::vector<PlacedMesh> meshes_outside(const tinygltf::Model& model,
                                       const std::vector<PlacedMesh>& placed) {
  std::set<const tinygltf::Mesh*> inside;
  for (const PlacedMesh& mesh : placed) inside.insert(mesh.mesh);
  std::vector<PlacedMesh> outside;
  for (const tinygltf::Mesh& mesh : model.meshes)
    if (!inside.contains(&mesh))
      outside.push_back(place(model, mesh, nullptr, Eigen::Affine3d::Identity()));
  return outside;
}

}  // namespace isomatch::mesh_io
