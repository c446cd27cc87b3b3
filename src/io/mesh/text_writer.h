// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string_view>

#include "isomatch/io/atomic_file.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::mesh_io {

/// How a text format spells a mesh.
struct TextLayout {
  std::string_view before_vertex;
  std::string_view before_face;
  /// Number of the first vertex.
  int first_index;
};

/// Writes a line for each vertex, then one for each face. Coordinates are spelled as shortly as
/// they can be read back exactly.
void write_text(const Mesh& mesh, const TextLayout& layout, AtomicFile& file);

}  // namespace isomatch::mesh_io
