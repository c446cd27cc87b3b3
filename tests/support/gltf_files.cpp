// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/gltf_files.h"

#include <cstdint>

#include "support/mesh_files.h"

namespace isomatch::test {
namespace {

std::string word(std::size_t value) {
  return bytes<std::uint32_t>(std::endian::little, {static_cast<std::uint32_t>(value)});
}

std::string chunk(std::string content, std::string_view kind, char padding) {
  content.resize((content.size() + 3) / 4 * 4, padding);
  return word(content.size()) + std::string(kind) + content;
}

}  // namespace

std::string glb(std::string json, std::string buffer) {
  using namespace std::string_view_literals;
  std::string chunks = chunk(std::move(json), "JSON"sv, ' ');
  if (!buffer.empty()) chunks += chunk(std::move(buffer), "BIN\0"sv, '\0');
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kAlphabet[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

std::string GltfText::json() const {
  const std::string all_nodes = nodes.empty() ? R"({"mesh":0)" + node + "}" : nodes;
  const std::string all_meshes = meshes.empty() ? R"({"primitives":[)" + parts + "]}" : meshes;
  const std::string scene = scenes.empty() ? "" : R"("scene":0,"scenes":[)" + scenes + "],";
  return R"({"asset":{"version":"2.0"},)" + scene + R"("nodes":[)" + all_nodes + R"(],"meshes":[)" +
         all_meshes +
         R"(],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)"
         R"("min":[0,0,-0.25],"max":[1.5,2,0]},)"
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})" +
         accessors +
         R"(],"bufferViews":[{"buffer":0,"byteLength":48},)"
         R"({"buffer":0,"byteOffset":48,"byteLength":24})" +
         views + R"(],"buffers":[{"byteLength":)" + std::to_string(bytes) + uri + "}]" + more + "}";
}

std::string tetrahedron_buffer() {
  std::string buffer;
  const Mesh mesh = tetrahedron();
  for (const Point& p : mesh.vertices)
    for (const double c : p) buffer += bytes<float>(std::endian::little, {static_cast<float>(c)});
  for (const Face& face : mesh.faces)
    for (const int v : face)
      buffer += bytes<std::uint16_t>(std::endian::little, {static_cast<std::uint16_t>(v)});
  return buffer;
}

}  // namespace isomatch::test
