// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

using Floats = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

std::string shape_of(const py::array& array) {
  return fmt::format("{}", fmt::join(array.shape(), array.shape() + array.ndim(), ", "));
}

/// Zero columns stand for an array of one dimension.
void check_shape(const py::array& array, std::string_view name, int columns) {
  if (columns == 0 && array.ndim() != 1)
    throw InvalidInput(fmt::format("{}: expected shape (N,), not ({})", name, shape_of(array)));
  if (columns != 0 && (array.ndim() != 2 || array.shape(1) != columns))
    throw InvalidInput(
        fmt::format("{}: expected shape (N, {}), not ({})", name, columns, shape_of(array)));
}

/// Whether all numbers are whole, of whatever type: text files and MATLAB give floats.
bool holds_integers(const py::array& array) {
  const char kind = array.dtype().kind();
  if (kind != 'f') return kind == 'i' || kind == 'u' || array.size() == 0;
  const Floats values(array);
  return std::all_of(values.data(), values.data() + values.size(), [](double value) {
    return std::abs(value) <= std::numeric_limits<std::int32_t>::max() &&
           std::floor(value) == value;
  });
}

int to_int(std::int64_t value, std::string_view name) {
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    throw InvalidInput(fmt::format("{}: {} is out of range", name, value));
  return static_cast<int>(value);
}

void check_weights(const SurfacePoint& point, std::size_t row) {
  constexpr double kTolerance = 1e-6;
  double sum = 0;
  for (const double weight : point.weights) {
    // Negated, so that NaN fails.
    if (!(weight >= -kTolerance && weight <= 1 + kTolerance))
      throw InvalidInput(
          fmt::format("barycentric: weight {} in row {} is not in [0, 1]", weight, row));
    sum += weight;
  }
  if (std::abs(sum - 1) > kTolerance)
    throw InvalidInput(fmt::format("barycentric: the weights in row {} do not sum to 1", row));
}

}  // namespace

py::array_t<double> to_array(std::vector<Point> points) {
  const auto size = static_cast<py::ssize_t>(points.size());
  return adopt<double>(std::move(points), {size, 3});
}

py::array_t<int> to_array(std::vector<Face> faces) {
  const auto size = static_cast<py::ssize_t>(faces.size());
  return adopt<int>(std::move(faces), {size, 3});
}

py::array_t<int> to_array(Correspondence matches) {
  const auto size = static_cast<py::ssize_t>(matches.size());
  return adopt<int>(std::move(matches), {size, 2});
}

std::pair<py::array_t<int>, py::array_t<double>> to_arrays(SurfaceMap map) {
  const auto size = static_cast<py::ssize_t>(map.size());
  constexpr py::ssize_t kStride = sizeof(SurfacePoint);
  auto* owner = new SurfaceMap(std::move(map));
  const py::capsule capsule(owner, [](void* points) { delete static_cast<SurfaceMap*>(points); });
  const SurfacePoint* first = owner->data();
  return {py::array_t<int>({size}, {kStride}, &first->face, capsule),
          py::array_t<double>({size, py::ssize_t{3}},
                              {kStride, static_cast<py::ssize_t>(sizeof(double))},
                              first->weights.data(), capsule)};
}

py::dict to_dict(const Mesh& mesh, SurfaceMap points) {
  py::dict result;
  result["vertices"] = adopt(nearest_vertices(mesh, points));
  auto [triangles, barycentric] = to_arrays(std::move(points));
  result["triangles"] = std::move(triangles);
  result["barycentric"] = std::move(barycentric);
  return result;
}

std::vector<int> to_integers(const py::array& array, std::string_view name, int columns) {
  check_shape(array, name, columns);
  if (!holds_integers(array)) throw InvalidInput(fmt::format("{}: expected integers", name));
  const Integers integers(array);
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(integers.size()));
  for (py::ssize_t i = 0; i < integers.size(); ++i)
    result.push_back(to_int(integers.data()[i], name));
  return result;
}

Doubles to_doubles(const py::array& array, std::string_view name, std::optional<int> columns) {
  if (array.ndim() != 2)
    throw InvalidInput(
        fmt::format("{}: expected two dimensions, not shape ({})", name, shape_of(array)));
  if (columns) check_shape(array, name, *columns);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw InvalidInput(fmt::format("{}: expected numbers", name));
  return Doubles(array);
}

std::vector<Point> to_points(const py::array& array, std::string_view name) {
  const Doubles coordinates = to_doubles(array, name, 3);
  std::vector<Point> points(static_cast<std::size_t>(coordinates.shape(0)));
  for (std::size_t v = 0; v < points.size(); ++v)
    points[v] = Eigen::Map<const Point>(coordinates.data() + 3 * v);
  return points;
}

Mesh to_mesh(const py::array& vertices, const py::array& faces) {
  const std::vector<int> corners = to_integers(faces, "faces", 3);
  Mesh mesh;
  mesh.vertices = to_points(vertices, "vertices");
  mesh.faces.resize(corners.size() / 3);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    mesh.faces[f] = {corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]};
  validate(mesh);
  return mesh;
}

std::vector<Match> to_matches(const py::array& pairs, std::string_view name) {
  const std::vector<int> numbers = to_integers(pairs, name, 2);
  std::vector<Match> matches;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    matches.push_back({numbers[i], numbers[i + 1]});
  return matches;
}

SurfaceMap to_surface_map(const py::array& faces, const py::array& weights) {
  const std::vector<int> face = to_integers(faces, "triangles");
  const Doubles weight = to_doubles(weights, "barycentric", 3);
  if (static_cast<std::size_t>(weight.shape(0)) != face.size())
    throw InvalidInput(
        fmt::format("triangles and barycentric: {} and {} rows", face.size(), weight.shape(0)));
  SurfaceMap map(face.size());
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (face[v] == kNoFace) continue;
    const double* row = weight.data() + 3 * v;
    map[v] = {face[v], {row[0], row[1], row[2]}};
    check_weights(map[v], v);
  }
  return map;
}

}  // namespace isomatch::python
