// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace isomatch::mesh_io {
namespace {

/// Extensions that a file may call required and that do not touch its vertices, or that are
/// understood.
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

void check_version(const InputFile& file, const tinygltf::Model& model) {
  const std::string& version = model.asset.version;
  if (!version.starts_with("2."))
    file.fail(fmt::format("glTF version {} is not supported, only 2.0", in_quotes(version)));
}

/// The JSON of a .glb or .gltf file, if there is any.
std::string_view json_of(const InputFile& file) {
  const std::string_view content = file.content();
  if (!content.starts_with("glTF")) return content;
  // Behind the file's header of 12 bytes and the chunk's of 8.
  constexpr std::size_t kLength = 12, kStart = 20;
  if (content.size() < kStart) return {};
  std::size_t length = 0;
  for (std::size_t i = 0; i < 4; ++i)
    length |= static_cast<std::size_t>(static_cast<unsigned char>(content[kLength + i])) << 8 * i;
  return content.substr(kStart, length);
}

/// Before the parser looks at the file, as extensions have a structure of their own: compressed
/// data leave holes that would be errors elsewhere. What is not JSON is left to the parser.
void check_extensions(const InputFile& file) {
  constexpr std::string_view kRequired = "extensionsRequired";
  const auto is_wanted = [&](int depth, nlohmann::json::parse_event_t event,
                             const nlohmann::json& key) {
    return depth != 1 || event != nlohmann::json::parse_event_t::key || key == kRequired;
  };
  const nlohmann::json json = nlohmann::json::parse(json_of(file), is_wanted, false);
  if (!json.is_object() || !json.contains(kRequired) || !json[kRequired].is_array()) return;
  for (const nlohmann::json& extension : json[kRequired]) {
    if (!extension.is_string()) continue;
    const auto name = extension.get<std::string>();
    if (!leaves_geometry_alone(name))
      file.fail(fmt::format("needs the extension {}, which is not supported",
                            one_line(name.substr(0, 60))));
  }
}

}  // namespace

tinygltf::Model load_gltf(const InputFile& file) {
  const std::string_view content = file.content();
  if (content.size() > std::numeric_limits<std::uint32_t>::max())
    file.fail("is larger than the 4 GiB that glTF allows");
  check_extensions(file);
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
  check_version(file, model);
  return model;
}

}  // namespace isomatch::mesh_io
