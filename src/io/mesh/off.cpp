// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "io/mesh/checks.h"
#include "io/mesh/formats.h"
#include "io/mesh/polygon.h"
#include "io/mesh/text_writer.h"
#include "io/text_cursor.h"

namespace isomatch::mesh_io {
namespace {

// The shortest vertex is "0 0 0\n", the shortest face, which is left out, "0\n".
constexpr int kVertexBytes = 6;
constexpr int kFaceBytes = 2;

/// Texture coordinates, colours and normals stand behind the position, where they are passed over.
constexpr std::array<std::string_view, 8> kKeywords = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                       "STOFF", "STCOFF", "STNOFF", "STCNOFF"};

struct Counts {
  int vertices;
  int faces;
};

bool is_number_start(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+'; }

/// The keyword may be missing if the counts are there at once, and, as in many public files, it may
/// be joined to them: OFF490 518 0.
void skip_keyword(TextCursor& cursor) {
  const std::string_view word = cursor.peek_word();
  const std::size_t end = word.find("OFF");
  if (end == std::string_view::npos) {
    if (is_number_start(word.front())) return;
    cursor.fail(fmt::format("expected OFF or the number of vertices, found {}", in_quotes(word)));
  }
  const std::string_view keyword = word.substr(0, end + 3);
  if (std::find(kKeywords.begin(), kKeywords.end(), keyword) == kKeywords.end())
    cursor.fail(fmt::format("unsupported kind of OFF file: {}", in_quotes(keyword)));
  cursor.set_position(keyword.data() + keyword.size());
  if (cursor.peek_word() == "BINARY") cursor.fail("binary OFF files are not supported");
}

/// The number of edges, the third of the counts, is of no use and often wrong or missing.
Counts read_counts(TextCursor& cursor) {
  if (!cursor.find_content()) cursor.fail("the file ends before the number of vertices");
  const std::int64_t vertices = cursor.integer();
  const std::int64_t faces = cursor.integer();
  if (!cursor.at_line_end()) cursor.integer();
  cursor.expect_line_end();
  // The last line may go without its end.
  const std::int64_t available = cursor.remaining() + 1;
  return {checked_count(cursor, vertices, "vertices", available, kVertexBytes),
          checked_count(cursor, faces, "faces", available, kFaceBytes)};
}

void read_vertices(TextCursor& cursor, int count, Mesh& mesh) {
  mesh.vertices.reserve(count);
  for (int i = 0; i < count; ++i) {
    if (!cursor.find_content())
      cursor.fail(fmt::format("the file ends after {} of {} vertices", i, count));
    const double x = cursor.coordinate(), y = cursor.coordinate(), z = cursor.coordinate();
    mesh.vertices.emplace_back(x, y, z);
    cursor.skip_line();
  }
}

void read_faces(TextCursor& cursor, int count, ReadResult& result) {
  result.mesh.faces.reserve(count);
  for (int i = 0; i < count; ++i) {
    if (!cursor.find_content())
      cursor.fail(fmt::format("the file ends after {} of {} faces", i, count));
    const std::int64_t corners = cursor.integer();
    if (corners < 0) cursor.fail(fmt::format("a face cannot have {} corners", corners));
    Polygon polygon(result);
    for (std::int64_t corner = 0; corner < corners; ++corner)
      polygon.add_corner(checked_index(cursor, cursor.integer(), result.mesh.num_vertices()));
    cursor.skip_line();
  }
}

}  // namespace

ReadResult read_off(const InputFile& file) {
  TextCursor cursor(file, {.comments = true});
  if (!cursor.find_content()) file.fail("the file holds nothing but blanks and comments");
  skip_keyword(cursor);
  const Counts counts = read_counts(cursor);
  ReadResult result;
  read_vertices(cursor, counts.vertices, result.mesh);
  read_faces(cursor, counts.faces, result);
  if (cursor.find_content())
    cursor.fail(fmt::format("more lines follow than the {} vertices and {} faces announced",
                            counts.vertices, counts.faces));
  return result;
}

void write_off(const Mesh& mesh, AtomicFile& file) {
  file.write(fmt::format("OFF\n{} {} 0\n", mesh.num_vertices(), mesh.num_faces()));
  write_text(mesh, {.before_vertex = "", .before_face = "3 ", .first_index = 0}, file);
}

}  // namespace isomatch::mesh_io
