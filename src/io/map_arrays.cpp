// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/map_arrays.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "io/npz.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

constexpr int kMost = std::numeric_limits<int>::max();

/// An array's value as an index from -1 to below `end`.
int checked_index(const InputFile& file, double value, int end, std::string_view what) {
  if (!(value >= kUnmatched && value < end) || std::floor(value) != value)
    file.fail(fmt::format("{} {} is out of range", what, value));
  return static_cast<int>(value);
}

VertexMap vertices_of(const InputFile& file, const NpyArray& array, const MapChecks& checks) {
  check_map_length(file, array.values.size(), checks);
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
  check_map_length(file, length, checks);
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

}  // namespace

void check_map_length(const InputFile& file, std::size_t length, const MapChecks& checks) {
  if (length > kMost) file.fail("the map is longer than this program can number");
  if (checks.source_vertices && std::cmp_not_equal(length, *checks.source_vertices))
    file.fail(fmt::format("the map is for {} vertices, but the source has {}", length,
                          *checks.source_vertices));
}

MapContent read_map_arrays(const std::string& path, const MapChecks& checks) {
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

void write_map_arrays(const std::string& path, const MapContent& map) {
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

}  // namespace isomatch
