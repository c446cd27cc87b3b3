// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "mesh_io/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "isomatch/mesh.h"

namespace isomatch::mesh_io {
namespace {

/// Extensions that a file may call required and that do not touch its vertices.
bool leaves_geometry_alone(const std::string& extension) {
  constexpr std::array<std::string_view, 5> kPrefixes = {
      "KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_mesh_quantization"};
  return std::ranges::any_of(kPrefixes, [&](auto prefix) { return extension.starts_with(prefix); });
}

bool pass_over_image(tinygltf::Image*, int, std::string*, std::string*, int, int,
                     const unsigned char*, int, void*) {
  return true;
}

/// The first line of what the parser says, which may quote anything.
std::string one_line(std::string text) {
  text = text.substr(0, text.find('\n'));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.empty() ? "no reason given" : text;
}

void check_supported(const InputFile& file, const tinygltf::Model& model) {
  const std::string& version = model.asset.version;
  if (!version.starts_with("2."))
    file.fail(fmt::format("glTF version {} is not supported, only 2.0", in_quotes(version)));
  for (const std::string& extension : model.extensionsRequired)
    if (!leaves_geometry_alone(extension))
      file.fail(fmt::format("needs the extension {}, which is not supported",
                            one_line(extension.substr(0, 60))));
}

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

class SceneSearch {
 public:
  SceneSearch(const InputFile& file, const tinygltf::Model& model)
      : file_(file), model_(model), visited_(model.nodes.size(), false) {}

  std::optional<PlacedMesh> below(const std::vector<int>& nodes, const Eigen::Affine3d& parent,
                                  int depth) {
    constexpr int kDeepest = 500;
    if (depth > kDeepest) file_.fail("its nodes are nested too deeply");
    for (const int index : nodes) {
      const tinygltf::Node& node = element(file_, model_.nodes, index, "node");
      if (visited_[index]) file_.fail(fmt::format("node {} has two parents", index));
      visited_[index] = true;
      const Eigen::Affine3d transform = parent * local_transform(node);
      if (node.mesh >= 0) return placed(node, transform);
      if (const auto found = below(node.children, transform, depth + 1)) return found;
    }
    return std::nullopt;
  }

 private:
  PlacedMesh placed(const tinygltf::Node& node, const Eigen::Affine3d& transform) const {
    const tinygltf::Mesh& mesh = element(file_, model_.meshes, node.mesh, "mesh");
    // By the specification only a skin's joints move it.
    if (node.skin >= 0) return {&mesh, Eigen::Affine3d::Identity()};
    return {&mesh, transform};
  }

  const InputFile& file_;
  const tinygltf::Model& model_;
  std::vector<bool> visited_;
};

}  // namespace

tinygltf::Model load_gltf(const InputFile& file) {
  const std::string_view content = file.content();
  if (content.size() > std::numeric_limits<std::uint32_t>::max())
    file.fail("is larger than the 4 GiB that glTF allows");
  const auto size = static_cast<unsigned>(content.size());
  const std::string folder = std::filesystem::path(file.path()).parent_path().string();
  tinygltf::TinyGLTF parser;
  parser.SetImageLoader(pass_over_image, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const bool loaded =
      content.starts_with("glTF")
          ? parser.LoadBinaryFromMemory(&model, &error, &warning,
                                        reinterpret_cast<const unsigned char*>(content.data()),
                                        size, folder)
          : parser.LoadASCIIFromString(&model, &error, &warning, std::to_address(content.begin()),
                                       size, folder);
  if (!loaded) file.fail("is not valid glTF: " + one_line(error));
  check_supported(file, model);
  return model;
}

PlacedMesh first_mesh(const InputFile& file, const tinygltf::Model& model) {
  if (!model.scenes.empty()) {
    const int shown = std::max(model.defaultScene, 0);
    const tinygltf::Scene& scene = element(file, model.scenes, shown, "scene");
    SceneSearch search(file, model);
    if (const auto found = search.below(scene.nodes, Eigen::Affine3d::Identity(), 0)) return *found;
  }
  if (model.meshes.empty()) file.fail("has no mesh");
  return {model.meshes.data(), Eigen::Affine3d::Identity()};
}

}  // namespace isomatch::mesh_io
