// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <vector>

#include "io/input_file.h"
#include "io/number_table.h"
#include "io/vertex_number.h"
#include "io/whole_number.h"
#include "isomatch/io/map_file.h"

namespace isomatch {
namespace {

/// One line of a file of landmarks.
Match read_landmark(TextCursor& cursor, const VertexRange& sources, const VertexRange& targets) {
  const int source = checked_vertex(read_number(cursor), sources);
  cursor.skip_separator();
  const int target = checked_vertex(read_number(cursor), targets);
  cursor.skip_separator();
  if (!cursor.at_line_end())
    cursor.fail(
        fmt::format("more than a source and a target vertex, {}; each landmark has a line "
                    "of its own, its name goes behind #",
                    in_quotes(cursor.word())));
  return {source, target};
}

}  // namespace

std::vector<Match> read_landmarks(const std::string& path, VertexCounts counts,
                                  Numbering numbering) {
  const InputFile file(path);
  const int first = static_cast<int>(numbering);
  const VertexRange sources{"source", counts.source, first};
  const VertexRange targets{"target", counts.target, first};
  std::vector<char> taken(counts.source, 0);
  std::vector<Match> landmarks;
  TextCursor cursor = table_rows(file);
  while (cursor.find_content()) {
    const TextCursor before = cursor;
    landmarks.push_back(read_landmark(cursor, sources, targets));
    char& is_taken = taken[landmarks.back().source];
    if (is_taken)
      before.fail(
          fmt::format("source vertex {} has a landmark already", landmarks.back().source + first));
    is_taken = 1;
  }
  if (landmarks.empty()) file.fail("no landmarks in it");
  return landmarks;
}

std::vector<int> read_vertex_list(const std::string& path, int num_vertices,
                                  std::optional<Numbering> numbering) {
  const Numbering by_name = is_vts_file_name(path) ? Numbering::kFromOne : Numbering::kFromZero;
  const VertexRange range{"shape", num_vertices, static_cast<int>(numbering.value_or(by_name))};
  const InputFile file(path);
  std::vector<int> vertices;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content()) {
    vertices.push_back(checked_vertex(read_number(cursor), range));
    if (!cursor.at_line_end())
      cursor.fail(fmt::format("more than a vertex, {}; each has a line of its own",
                              in_quotes(cursor.word())));
  }
  if (vertices.empty()) file.fail("no vertices in it");
  return vertices;
}

}  // namespace isomatch
