// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/text_writer.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <iterator>

namespace isomatch::mesh_io {
namespace {

template <class T>
void write_line(AtomicFile& file, std::string_view before, T a, T b, T c) {
  fmt::memory_buffer line;
  fmt::format_to(std::back_inserter(line), FMT_COMPILE("{}{} {} {}\n"), before, a, b, c);
  file.write({line.data(), line.size()});
}

}  // namespace

void write_text(const Mesh& mesh, const TextLayout& layout, AtomicFile& file) {
  for (const Point& p : mesh.vertices) write_line(file, layout.before_vertex, p.x(), p.y(), p.z());
  const int first = layout.first_index;
  for (const auto& [a, b, c] : mesh.faces)
    write_line(file, layout.before_face, a + first, b + first, c + first);
}

}  // namespace isomatch::mesh_io
