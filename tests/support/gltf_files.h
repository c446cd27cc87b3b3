// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// glTF files for tests.
namespace isomatch::test {

/// A .glb file of these two chunks, padded as it must be; no second chunk if `buffer` is empty.
std::string glb(std::string json, std::string buffer);

std::string base64(std::string_view bytes);

/// The JSON of a glTF file whose single buffer has the positions of four vertices in 32 bits each,
/// from byte 0, and twelve 16-bit corners, from byte 48: accessors and buffer views 0 and 1.
/// `parts` replaces the mesh's primitives, `node` is added to the node, `uri` to the buffer, `more`
/// to the top level; `scenes`, `nodes` and `meshes` replace these lists; `accessors` and `views`
/// come after the two, beginning with a comma; `bytes` is the buffer's length.
struct GltfText {
  std::string parts = R"({"attributes":{"POSITION":0},"indices":1})";
  std::string node = {};
  std::string uri = {};
  std::string more = {};
  std::string scenes = R"({"nodes":[0]})";
  std::string nodes = {};
  std::string meshes = {};
  std::string accessors = {};
  std::string views = {};
  std::size_t bytes = 72;

  std::string json() const;
};

/// The buffer of the same: `tetrahedron()`.
std::string tetrahedron_buffer();

}  // namespace isomatch::test
