// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/map_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <ranges>
#include <utility>
#include <vector>

#include "io/input_file.h"
#include "io/npz.h"
#include "io/text_cursor.h"
#include "io/whole_number.h"
#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

constexpr int kMost = std::numeric_limits<int>::max();

bool has_ending(const std::string& path, std::string_view ending) {
  return path.size() >= ending.size() &&
         equal_ignoring_case(std::string_view(path).substr(path.size() - ending.size()), ending);
}

void check_name(const std::string& path) {
  if (!is_map_file_name(path))
    throw BadFile(path, "the ending is not that of a map: .txt .map .vts .bary.txt .npz");
}

/// A number of a file, and where it stands.
struct Line {
  std::int64_t number;
  TextCursor cursor;
};

Line read_line(TextCursor& cursor) {
  const TextCursor before = cursor;
  return {whole_number(cursor), before};
}

std::vector<Line> read_lines(const InputFile& file) {
  std::vector<Line> lines;
  TextCursor cursor(file, kNumberLines);
  while (cursor.find_content()) {
    lines.push_back(read_line(cursor));
    if (!cursor.at_line_end())
      cursor.fail("one vertex a line expected; a file of points is named .bary.txt");
  }
  if (lines.empty()) file.fail("no vertices in it");
  return lines;
}

/// See `read_map`.
MapReadReport detected(const std::vector<Line>& lines, const MapChecks& checks) {
  const auto numbers = lines | std::views::transform(&Line::number);
  const auto [low, high] = std::ranges::minmax(numbers);
  if (checks.target_vertices && high == *checks.target_vertices && low > kUnmatched)
    return {Numbering::kFromOne, false};
  return {Numbering::kFromZero, low > 0};
}

/// A line of a list of pairs, and where its words stand.
struct PairLine {
  Line source, target;
};

std::vector<PairLine> read_pairs(const InputFile& file) {
  std::vector<PairLine> pairs;
  for (TextCursor cursor(file, kNumberLines); cursor.find_content(); cursor.skip_line()) {
    const Line source = read_line(cursor);
    pairs.push_back({source, read_line(cursor)});
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

int checked_vertex(const Line& line, std::string_view shape, std::optional<int> count, int first) {
  const std::int64_t end = std::int64_t{first} + count.value_or(kMost - 1);
  if (line.number < first || line.number >= end)
    line.cursor.fail(count ? fmt::format("vertex {} is out of range: the {} has {} vertices, "
                                         "numbered from {}",
                                         line.number, shape, *count, first)
                           : fmt::format("{} is no vertex numbered from {}", line.number, first));
  return static_cast<int>(line.number - first);
}

Correspondence read_pair_list(const std::string& path, const MapChecks& checks,
                              std::optional<Numbering> numbering, MapReadReport& used) {
  const InputFile file(path);
  const std::vector<PairLine> pairs = read_pairs(file);
  used = numbering ? MapReadReport{*numbering, false} : detected(pairs, checks);
  const int first = static_cast<int>(used.numbering);
  Correspondence matches;
  for (const auto& [source, target] : pairs)
    matches.push_back({checked_vertex(source, "source", checks.source_vertices, first),
                       checked_vertex(target, "target", checks.target_vertices, first)});
  std::ranges::sort(matches);
  matches.erase(std::ranges::unique(matches).begin(), matches.end());
  return matches;
}

VertexMap numbered_from_zero(const std::vector<Line>& lines, int first, int lowest,
                             const MapChecks& checks) {
  const std::int64_t end = std::int64_t{first} + checks.target_vertices.value_or(kMost - 1);
  VertexMap map;
  map.reserve(lines.size());
  for (const auto& [number, cursor] : lines) {
    if (number < lowest || number >= end)
      cursor.fail(
          checks.target_vertices
              ? fmt::format("vertex {} is out of range: the target has {}, numbered from {}",
                            number, *checks.target_vertices, first)
              : fmt::format("{} is no vertex numbered from {}", number, first));
    map.push_back(static_cast<int>(number - first));
  }
  return map;
}

void check_length(const InputFile& file, std::size_t length, const MapChecks& checks) {
  if (length > kMost) file.fail("the map is longer than this program can number");
  if (checks.source_vertices && std::cmp_not_equal(length, *checks.source_vertices))
    file.fail(fmt::format("the map is for {} vertices, but the source has {}", length,
                          *checks.source_vertices));
}

int line_count(const InputFile& file) {
  int lines = 0;
  TextCursor cursor(file, kNumberLines);
  for (; cursor.find_content(); cursor.skip_line()) ++lines;
  return lines;
}

MapContent read_points(const std::string& path, const MapChecks& checks, Numbering numbering) {
  const int lines = line_count(InputFile(path));
  // The largest number that can be counted from one.
  const SurfaceMapCounts counts{checks.source_vertices.value_or(lines),
                                checks.target_faces.value_or(kMost - 1)};
  return {{}, read_surface_map(path, counts, numbering)};
}

/// An array's value as an index from -1 to below `end`.
int checked_index(const InputFile& file, double value, int end, std::string_view what) {
  if (!(value >= kUnmatched && value < end) || std::floor(value) != value)
    file.fail(fmt::format("{} {} is out of range", what, value));
  return static_cast<int>(value);
}

VertexMap vertices_of(const InputFile& file, const NpyArray& array, const MapChecks& checks) {
  check_length(file, array.values.size(), checks);
  VertexMap map;
  map.reserve(array.values.size());
  for (const double value : array.values)
    map.push_back(checked_index(file, value, checks.target_vertices.value_or(kMost), "vertex"));
  return map;
}

SurfaceMap points_of(const InputFile& file, const NpyArray& triangles, const NpyArray& weights,
                     const MapChecks& checks) {
  // How far weights may be off by the rounding of whoever wrote them, maybe in 32 bits.
  constexpr double kWeightTolerance = 1e-6;
  const std::size_t length = triangles.values.size();
  check_length(file, length, checks);
  if (weights.values.size() != 3 * length) file.fail("barycentric is not three times triangles");
  SurfaceMap map(length);
  for (std::size_t v = 0; v < length; ++v) {
    SurfacePoint& point = map[v];
    point.face =
        checked_index(file, triangles.values[v], checks.target_faces.value_or(kMost), "triangle");
    if (point.face == kNoFace) continue;
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      point.weights[k] = weights.values[3 * v + k];
      if (!(point.weights[k] >= -kWeightTolerance && point.weights[k] <= 1 + kWeightTolerance))
        file.fail(fmt::format("weight {} of vertex {} is not in [0, 1]", point.weights[k], v));
      sum += point.weights[k];
    }
    if (std::abs(sum - 1) > kWeightTolerance)
      file.fail(fmt::format("the weights of vertex {} sum to {} instead of 1", v, sum));
  }
  return map;
}

/// The one array that can be a vertex map, if it goes by another name.
const NpyArray* nameless(const NpzArrays& arrays) {
  const NpyArray* found = nullptr;
  for (const auto& [name, array] : arrays) {
    if (!array.has_integers || array.shape.size() != 1) continue;
    if (found) return nullptr;
    found = &array;
  }
  return found;
}

MapContent read_arrays(const std::string& path, const MapChecks& checks) {
  const InputFile file(path);
  const NpzArrays arrays = read_npz(file);
  const auto find = [&](const char* name) {
    const auto found = arrays.find(name);
    return found == arrays.end() ? nullptr : &found->second;
  };
  const NpyArray* vertices = find("source_to_target");
  const NpyArray *const triangles = find("triangles"), *const weights = find("barycentric");
  const bool has_points = triangles && weights;
  if (!vertices && !has_points) vertices = nameless(arrays);
  if (!vertices && !has_points)
    file.fail("has no map: source_to_target, or triangles and barycentric");
  MapContent map;
  if (vertices) map.source_to_target = vertices_of(file, *vertices, checks);
  if (has_points) map.points = points_of(file, *triangles, *weights, checks);
  if (vertices && has_points && map.points.size() != map.source_to_target.size())
    file.fail("source_to_target and triangles are not equally long");
  return map;
}

void write_arrays(const std::string& path, const MapContent& map) {
  NpzArrays arrays;
  if (const auto& vertices = map.source_to_target; !vertices.empty())
    arrays["source_to_target"] = {{std::ssize(vertices)}, {vertices.begin(), vertices.end()}, true};
  if (!map.points.empty()) {
    NpyArray triangles{{std::ssize(map.points)}, {}, true};
    NpyArray weights{{std::ssize(map.points), 3}, {}, false};
    for (const SurfacePoint& point : map.points) {
      triangles.values.push_back(point.face);
      weights.values.insert(weights.values.end(), point.weights.begin(), point.weights.end());
    }
    arrays["triangles"] = std::move(triangles);
    arrays["barycentric"] = std::move(weights);
  }
  AtomicFile file(path);
  write_npz(arrays, file);
  file.commit();
}

VertexMap shifted(VertexMap map, int by) {
  for (int& vertex : map) vertex += by;
  return map;
}

SurfaceMap shifted(SurfaceMap map, int by) {
  for (SurfacePoint& point : map) point.face += by;
  return map;
}

}  // namespace

bool is_point_map_file_name(const std::string& path) { return has_ending(path, ".bary.txt"); }

bool is_vts_file_name(const std::string& path) { return has_ending(path, ".vts"); }

bool is_map_file_name(const std::string& path) {
  return std::ranges::any_of(std::array{".txt", ".map", ".vts", ".npz"},
                             [&](const char* ending) { return has_ending(path, ending); });
}

bool lists_pairs(const std::string& path) {
  if (is_point_map_file_name(path) || !(has_ending(path, ".txt") || has_ending(path, ".map")))
    return false;
  const InputFile file(path);
  TextCursor cursor(file, kNumberLines);
  if (!cursor.find_content()) return false;
  cursor.word();
  return !cursor.at_line_end();
}

void check_map_output(const std::string& path) {
  check_name(path);
  const AtomicFile attempt(path);
}

MapContent read_map(const std::string& path, const MapChecks& checks,
                    std::optional<Numbering> numbering, MapReadReport* report) {
  check_name(path);
  MapReadReport used{numbering.value_or(Numbering::kFromZero), false};
  MapContent map;
  if (is_point_map_file_name(path)) {
    map = read_points(path, checks, used.numbering);
  } else if (has_ending(path, ".npz")) {
    used.numbering = Numbering::kFromZero;
    map = read_arrays(path, checks);
  } else {
    const InputFile file(path);
    const std::vector<Line> lines = read_lines(file);
    check_length(file, lines.size(), checks);
    const bool is_vts = is_vts_file_name(path);
    if (is_vts)
      used.numbering = Numbering::kFromOne;
    else if (!numbering)
      used = detected(lines, checks);
    const int first = static_cast<int>(used.numbering);
    map.source_to_target = numbered_from_zero(lines, first, is_vts ? first : first - 1, checks);
  }
  if (report) *report = used;
  return map;
}

MatchContent read_matches(const std::string& path, const MapChecks& checks,
                          std::optional<Numbering> numbering, MapReadReport* report) {
  check_name(path);
  if (!lists_pairs(path)) {
    MapContent map = read_map(path, checks, numbering, report);
    return {to_correspondence(map.source_to_target), std::move(map.points)};
  }
  MapReadReport used;
  MatchContent content{read_pair_list(path, checks, numbering, used), {}};
  if (report) *report = used;
  return content;
}

std::vector<int> read_ground_truth(const std::string& path, std::optional<int> num_vertices) {
  std::vector<int> vertices =
      read_map(path, {std::nullopt, num_vertices, std::nullopt}).source_to_target;
  if (vertices.empty()) throw BadFile(path, "points on triangles are no template's vertices");
  if (const auto none = std::ranges::find(vertices, kUnmatched); none != vertices.end())
    throw BadFile(path, fmt::format("template point {} has no vertex", none - vertices.begin()));
  return vertices;
}

void write_map(const std::string& path, const MapContent& map, Numbering numbering) {
  check_name(path);
  const bool is_points = is_point_map_file_name(path), is_arrays = has_ending(path, ".npz");
  const VertexMap& vertices = map.source_to_target;
  if (is_arrays ? vertices.empty() && map.points.empty()
                : (is_points ? map.points.empty() : vertices.empty()))
    throw InvalidInput("write_map: this form of the map is not known");
  const int first = static_cast<int>(numbering);
  if (is_arrays) {
    write_arrays(path, map);
  } else if (is_points) {
    write_surface_map(path, shifted(map.points, first));
  } else if (!is_vts_file_name(path)) {
    write_source_to_target(path, shifted(vertices, first));
  } else {
    if (std::ranges::find(vertices, kUnmatched) != vertices.end())
      throw InvalidInput(".vts files have no word for unmatched vertices, which this map has");
    write_vts(path, vertices);
  }
}

}  // namespace isomatch
