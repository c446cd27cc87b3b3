// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/gltf_coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace isomatch::mesh_io {
namespace {

/// How a material uses an image.
struct TextureUse {
  int set = 0;
  tinygltf::Value transform;
};

template <class Info>
bool find_use(const Info& info, TextureUse& use) {
  if (info.index < 0) return false;
  use.set = info.texCoord;
  const auto found = info.extensions.find("KHR_texture_transform");
  if (found != info.extensions.end()) use.transform = found->second;
  return true;
}

TextureUse texture_use(const tinygltf::Model& model, int material) {
  TextureUse use;
  if (material < 0 || material >= std::ssize(model.materials)) return use;
  const tinygltf::Material& m = model.materials[material];
  find_use(m.pbrMetallicRoughness.baseColorTexture, use) || find_use(m.emissiveTexture, use) ||
      find_use(m.normalTexture, use) || find_use(m.occlusionTexture, use) ||
      find_use(m.pbrMetallicRoughness.metallicRoughnessTexture, use);
  return use;
}

double number_or(const tinygltf::Value& value, double otherwise) {
  return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

std::array<double, 2> pair_or(const tinygltf::Value& object, const std::string& key,
                              double otherwise) {
  if (!object.Has(key)) return {otherwise, otherwise};
  const tinygltf::Value& list = object.Get(key);
  if (!list.IsArray() || list.ArrayLen() != 2) return {otherwise, otherwise};
  return {number_or(list.Get(0), otherwise), number_or(list.Get(1), otherwise)};
}

}  // namespace

GltfCoordinates::Transform GltfCoordinates::transform_of(const tinygltf::Primitive& primitive,
                                                         int& set) const {
  const auto [used_set, object] = texture_use(model_, primitive.material);
  set = used_set;
  if (!object.IsObject()) return {1, 0, 0, 0, 1, 0};
  if (object.Has("texCoord") && object.Get("texCoord").IsInt())
    set = object.Get("texCoord").GetNumberAsInt();
  const auto [u, v] = pair_or(object, "offset", 0);
  const auto [along_u, along_v] = pair_or(object, "scale", 1);
  const double angle = object.Has("rotation") ? number_or(object.Get("rotation"), 0) : 0;
  // Counter-clockwise as one sees it, while v points down.
  const double c = std::cos(angle), s = std::sin(angle);
  const Transform transform{c * along_u, s * along_v, u, -s * along_u, c * along_v, v};
  if (!std::ranges::all_of(transform, [](double x) { return std::isfinite(x); }))
    file_.fail("a texture transform is not finite");
  return transform;
}

int GltfCoordinates::add(const tinygltf::Primitive& primitive, Eigen::Index vertices,
                         Texture& texture) {
  int set = 0;
  const Transform t = transform_of(primitive, set);
  const auto attribute = primitive.attributes.find(fmt::format("TEXCOORD_{}", set));
  if (attribute == primitive.attributes.end()) return Texture::kNone;
  accessors_.check_rows(attribute->second, vertices);
  const auto [entry, is_new] =
      first_.try_emplace({attribute->second, t}, static_cast<int>(texture.coordinates.size()));
  if (!is_new) return entry->second;
  const Eigen::MatrixXd values = accessors_.read(attribute->second, 2);
  for (Eigen::Index i = 0; i < vertices; ++i) {
    const double u = values(i, 0), v = values(i, 1);
    const Eigen::Vector2d moved(t[0] * u + t[1] * v + t[2], t[3] * u + t[4] * v + t[5]);
    if (!moved.allFinite()) file_.fail("a texture coordinate is not finite");
    texture.coordinates.emplace_back(moved.x(), 1 - moved.y());
  }
  return entry->second;
}

}  // namespace isomatch::mesh_io
