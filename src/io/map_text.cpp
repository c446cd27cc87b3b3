// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/map_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ranges>
#include <vector>

#include "io/input_file.h"
#include "io/line_writer.h"
#include "io/map_arrays.h"
#include "io/vertex_number.h"
#include "io/whole_number.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

std::vector<FileNumber> read_vertex_lines(const InputFile& file) {
  std::vector<FileNumber> lines;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content()) {
    lines.push_back(read_number(cursor));
    if (!cursor.at_line_end())
      cursor.fail("one vertex a line expected; a file of points is named .bary.txt");
  }
  if (lines.empty()) file.fail("no vertices in it");
  return lines;
}

/// See `read_map`.
MapReadReport detected(const std::vector<FileNumber>& lines, const MapChecks& checks) {
  const auto numbers = lines | std::views::transform(&FileNumber::number);
  const auto [low, high] = std::ranges::minmax(numbers);
  if (checks.target_vertices && high == *checks.target_vertices && low > kUnmatched)
    return {Numbering::kFromOne, false};
  return {Numbering::kFromZero, low > 0};
}

/// A line of a list of pairs, and where its words stand.
struct PairLine {
  FileNumber source, target;
};

std::vector<PairLine> read_pair_lines(const InputFile& file) {
  std::vector<PairLine> pairs;
  for (TextCursor cursor(file, kNumberLines); cursor.find_content(); cursor.skip_line()) {
    const FileNumber source = read_number(cursor);
    pairs.push_back({source, read_number(cursor)});
  }
  return pairs;
}

/// As `detected`: numbered from one where nothing else can be.
MapReadReport detected(const std::vector<PairLine>& pairs, const MapChecks& checks) {
  bool past_end = false, has_zero = false;
  for (const auto& [source, target] : pairs) {
    has_zero |= source.number <= 0 || target.number <= 0;
    past_end |= source.number == checks.source_vertices.value_or(kUnmatched) ||
                target.number == checks.target_vertices.value_or(kUnmatched);
  }
  if (past_end && !has_zero) return {Numbering::kFromOne, false};
  return {Numbering::kFromZero, !has_zero};
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

}  // namespace

VertexMap read_vertex_map(const std::string& path, const MapChecks& checks,
                          std::optional<Numbering> numbering, MapReadReport& used) {
  const InputFile file(path);
  const std::vector<FileNumber> lines = read_vertex_lines(file);
  check_map_length(file, lines.size(), checks);
  used = numbering ? MapReadReport{*numbering, false} : detected(lines, checks);
  const VertexRange targets{"target", checks.target_vertices, static_cast<int>(used.numbering)};
  VertexMap map;
  map.reserve(lines.size());
  for (const FileNumber& line : lines) map.push_back(checked_vertex(line, targets, true));
  return map;
}

Correspondence read_pairs(const std::string& path, const MapChecks& checks,
                          std::optional<Numbering> numbering, MapReadReport& used) {
  const InputFile file(path);
  const std::vector<PairLine> pairs = read_pair_lines(file);
  used = numbering ? MapReadReport{*numbering, false} : detected(pairs, checks);
  const int first = static_cast<int>(used.numbering);
  const VertexRange sources{"source", checks.source_vertices, first};
  const VertexRange targets{"target", checks.target_vertices, first};
  Correspondence matches;
  for (const auto& [source, target] : pairs)
    matches.push_back({checked_vertex(source, sources), checked_vertex(target, targets)});
  std::ranges::sort(matches);
  matches.erase(std::ranges::unique(matches).begin(), matches.end());
  return matches;
}

SurfaceMap read_points(const std::string& path, const MapChecks& checks, Numbering numbering) {
  const InputFile file(path);
  // Otherwise the largest number that can be counted from one.
  const int faces = checks.target_faces.value_or(std::numeric_limits<int>::max() - 1);
  SurfaceMap map;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content())
    map.push_back(read_surface_point(cursor, faces, static_cast<int>(numbering)));
  if (checks.source_vertices && std::ssize(map) != *checks.source_vertices)
    file.fail(fmt::format("the map has {} lines, but the source has {} vertices", map.size(),
                          *checks.source_vertices));
  return map;
}

void write_vertex_map(const std::string& path, const VertexMap& map, int first) {
  AtomicFile file(path);
  LineWriter lines(file);
  for (const int vertex : map) lines.add("{}", vertex + first);
  file.commit();
}

void write_points(const std::string& path, const SurfaceMap& map, int first) {
  AtomicFile file(path);
  LineWriter lines(file);
  for (const auto& [face, weights] : map)
    lines.add("{} {} {} {}", face + first, weights[0], weights[1], weights[2]);
  file.commit();
}

}  // namespace isomatch
