// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/map_file.h"

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

#include "input_file.h"
#include "isomatch/atomic_file.h"
#include "isomatch/error.h"
#include "isomatch/topology.h"
#include "npz.h"
#include "text_cursor.h"

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

std::vector<Line> read_lines(const InputFile& file) {
  std::vector<Line> lines;
  TextCursor cursor(file);
  while (cursor.find_content()) {
    const TextCursor before = cursor;
    lines.push_back({cursor.integer(), before});
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
  TextCursor cursor(file);
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
  constexpr double kTolerance = 1e-6;
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
      if (!(point.weights[k] >= -kTolerance && point.weights[k] <= 1 + kTolerance))
        file.fail(fmt::format("weight {} of vertex {} is not in [0, 1]", point.weights[k], v));
      sum += point.weights[k];
    }
    if (std::abs(sum - 1) > kTolerance)
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

bool is_map_file_name(const std::string& path) {
  return std::ranges::any_of(std::array{".txt", ".map", ".vts", ".npz"},
                             [&](const char* ending) { return has_ending(path, ending); });
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
    const bool is_vts = has_ending(path, ".vts");
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
  } else if (!has_ending(path, ".vts")) {
    write_source_to_target(path, shifted(vertices, first));
  } else {
    if (std::ranges::find(vertices, kUnmatched) != vertices.end())
      throw InvalidInput(".vts files have no word for unmatched vertices, which this map has");
    write_vts(path, vertices);
  }
}

}  // namespace isomatch
