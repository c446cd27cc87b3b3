// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/map_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "io/input_file.h"
#include "io/number_table.h"
#include "io/text_cursor.h"
#include "io/whole_number.h"
#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

/// One shape's vertices as a file numbers them.
struct VertexRange {
  std::string_view shape;
  int count;
  int first;
};

VertexRange source_range(VertexCounts counts, Numbering numbering) {
  return {"source", counts.source, static_cast<int>(numbering)};
}

VertexRange target_range(VertexCounts counts, Numbering numbering) {
  return {"target", counts.target, static_cast<int>(numbering)};
}

[[noreturn]] void fail_out_of_range(const TextCursor& cursor, std::int64_t number,
                                    const VertexRange& range) {
  cursor.fail(fmt::format("vertex {} is out of range: the {} has {} vertices, numbered from {}",
                          number, range.shape, range.count, range.first));
}

/// The next word as a 0-based vertex; `kUnmatched` only if `may_be_unmatched`.
int read_vertex(TextCursor& cursor, const VertexRange& range, bool may_be_unmatched) {
  const TextCursor before = cursor;
  const std::int64_t number = whole_number(cursor);
  const std::int64_t lowest = range.first - (may_be_unmatched ? 1 : 0);
  if (number < lowest || number >= std::int64_t{range.first} + range.count)
    fail_out_of_range(before, number, range);
  return static_cast<int>(number - range.first);
}

VertexMap read_map_lines(const InputFile& file, VertexCounts counts, Numbering numbering) {
  const VertexRange targets = target_range(counts, numbering);
  VertexMap source_to_target;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content()) {
    source_to_target.push_back(read_vertex(cursor, targets, true));
    cursor.expect_line_end();
  }
  if (std::ssize(source_to_target) != counts.source)
    file.fail(fmt::format("the map has {} lines, but the source has {} vertices",
                          source_to_target.size(), counts.source));
  return source_to_target;
}

Correspondence read_pair_lines(const InputFile& file, VertexCounts counts, Numbering numbering) {
  const VertexRange sources = source_range(counts, numbering);
  const VertexRange targets = target_range(counts, numbering);
  Correspondence matches;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content()) {
    const int source = read_vertex(cursor, sources, false);
    matches.push_back({source, read_vertex(cursor, targets, false)});
    cursor.skip_line();
  }
  std::sort(matches.begin(), matches.end());
  matches.erase(std::unique(matches.begin(), matches.end()), matches.end());
  return matches;
}

/// One line of a file of landmarks.
Match read_landmark(TextCursor& cursor, const VertexRange& sources, const VertexRange& targets) {
  const int source = read_vertex(cursor, sources, false);
  cursor.skip_separator();
  const int target = read_vertex(cursor, targets, false);
  cursor.skip_separator();
  if (!cursor.at_line_end())
    cursor.fail(
        fmt::format("more than a source and a target vertex, {}; each landmark has a line "
                    "of its own, its name goes behind #",
                    in_quotes(cursor.word())));
  return {source, target};
}

std::vector<Match> read_landmark_lines(const InputFile& file, VertexCounts counts,
                                       Numbering numbering) {
  const VertexRange sources = source_range(counts, numbering);
  const VertexRange targets = target_range(counts, numbering);
  std::vector<char> taken(counts.source, 0);
  std::vector<Match> landmarks;
  TextCursor cursor = table_rows(file);
  while (cursor.find_content()) {
    const TextCursor before = cursor;
    landmarks.push_back(read_landmark(cursor, sources, targets));
    char& is_taken = taken[landmarks.back().source];
    if (is_taken)
      before.fail(fmt::format("source vertex {} has a landmark already",
                              landmarks.back().source + sources.first));
    is_taken = 1;
  }
  if (landmarks.empty()) file.fail("no landmarks in it");
  return landmarks;
}

std::vector<int> read_vertex_lines(const std::string& path, const VertexRange& range) {
  const InputFile file(path);
  std::vector<int> vertices;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content()) {
    vertices.push_back(read_vertex(cursor, range, false));
    if (!cursor.at_line_end())
      cursor.fail(fmt::format("more than a vertex, {}; each has a line of its own",
                              in_quotes(cursor.word())));
  }
  if (vertices.empty()) file.fail("no vertices in it");
  return vertices;
}

/// How far weights may be off by the rounding of whoever wrote them.
constexpr double kWeightTolerance = 1e-6;

std::array<double, 3> read_weights(TextCursor& cursor) {
  std::array<double, 3> weights{};
  for (double& weight : weights) {
    const TextCursor before = cursor;
    weight = cursor.number();
    if (weight < -kWeightTolerance || weight > 1 + kWeightTolerance)
      before.fail(fmt::format("weight {} is not in [0, 1]", weight));
  }
  return weights;
}

SurfacePoint read_surface_point(TextCursor& cursor, int num_faces, int first) {
  const TextCursor before = cursor;
  const std::int64_t number = whole_number(cursor);
  if (number < std::int64_t{first} - 1 || number >= std::int64_t{first} + num_faces)
    before.fail(fmt::format("face {} is out of range: the target has {} faces, numbered from {}",
                            number, num_faces, first));
  const SurfacePoint point{static_cast<int>(number - first), read_weights(cursor)};
  const double sum = point.weights[0] + point.weights[1] + point.weights[2];
  const double expected = point.face == kNoFace ? 0 : 1;
  if (std::abs(sum - expected) > kWeightTolerance)
    before.fail(fmt::format("the weights sum to {} instead of {}", sum, expected));
  cursor.expect_line_end();
  return point;
}

bool first_line_has_two_words(const InputFile& file) {
  TextCursor cursor(file, kNumberLines);
  if (!cursor.find_content()) file.fail("no vertices in it");
  cursor.word();
  return !cursor.at_line_end();
}

template <class Formatter>
void write_lines(const std::string& path, std::size_t count, const Formatter& append_line) {
  AtomicFile file(path);
  fmt::memory_buffer line;
  for (std::size_t i = 0; i < count; ++i) {
    line.clear();
    append_line(std::back_inserter(line), i);
    file.write({line.data(), line.size()});
  }
  file.commit();
}

}  // namespace

Correspondence read_correspondence(const std::string& path, VertexCounts counts,
                                   Numbering numbering) {
  const InputFile file(path);
  if (first_line_has_two_words(file)) return read_pair_lines(file, counts, numbering);
  return to_correspondence(read_map_lines(file, counts, numbering));
}

VertexMap read_source_to_target(const std::string& path, VertexCounts counts, Numbering numbering) {
  return read_map_lines(InputFile(path), counts, numbering);
}

std::vector<Match> read_landmarks(const std::string& path, VertexCounts counts,
                                  Numbering numbering) {
  return read_landmark_lines(InputFile(path), counts, numbering);
}

SurfaceMap read_surface_map(const std::string& path, SurfaceMapCounts counts, Numbering numbering) {
  const InputFile file(path);
  SurfaceMap map;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content())
    map.push_back(read_surface_point(cursor, counts.target_faces, static_cast<int>(numbering)));
  if (std::ssize(map) != counts.source_vertices)
    file.fail(fmt::format("the map has {} lines, but the source has {} vertices", map.size(),
                          counts.source_vertices));
  return map;
}

std::vector<int> read_vertex_list(const std::string& path, int num_vertices) {
  const bool is_vts = equal_ignoring_case(std::filesystem::path(path).extension().string(), ".vts");
  return read_vertex_lines(path, {"shape", num_vertices, is_vts ? 1 : 0});
}

std::vector<int> read_vts(const std::string& path, int num_vertices) {
  return read_vertex_lines(path, {"shape", num_vertices, 1});
}

void write_source_to_target(const std::string& path, const VertexMap& source_to_target) {
  write_lines(path, source_to_target.size(),
              [&](auto out, std::size_t i) { fmt::format_to(out, "{}\n", source_to_target[i]); });
}

void write_correspondence(const std::string& path, const Correspondence& correspondence,
                          std::span<const double> d_iso) {
  if (!d_iso.empty() && d_iso.size() != correspondence.size())
    throw InvalidInput("write_correspondence needs a distortion for every match or none");
  write_lines(path, correspondence.size(), [&](auto out, std::size_t i) {
    const auto [source, target] = correspondence[i];
    if (d_iso.empty())
      fmt::format_to(out, "{} {}\n", source, target);
    else
      fmt::format_to(out, "{} {} {}\n", source, target, d_iso[i]);
  });
}

void write_surface_map(const std::string& path, const SurfaceMap& map) {
  write_lines(path, map.size(), [&](auto out, std::size_t i) {
    const auto& [face, weights] = map[i];
    fmt::format_to(out, "{} {} {} {}\n", face, weights[0], weights[1], weights[2]);
  });
}

void write_vts(const std::string& path, const std::vector<int>& vertices) {
  write_lines(path, vertices.size(),
              [&](auto out, std::size_t i) { fmt::format_to(out, "{}\n", vertices[i] + 1); });
}

}  // namespace isomatch
