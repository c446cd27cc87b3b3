// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <pybind11/stl.h>

#include <optional>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/io/map_file.h"
#include "shapes.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

/// (vertices, faces) of a mesh, or None.
using GivenMesh = std::optional<std::pair<py::array, py::array>>;

std::optional<Mesh> given_mesh(const GivenMesh& mesh) {
  if (!mesh) return std::nullopt;
  return to_mesh(mesh->first, mesh->second);
}

MapChecks checks_of(std::optional<int> source_vertices, const std::optional<Mesh>& target) {
  if (!target) return {source_vertices, std::nullopt, std::nullopt};
  return {source_vertices, target->num_vertices(), target->num_faces()};
}

std::optional<Numbering> numbering_of(std::optional<bool> one_based) {
  if (!one_based) return std::nullopt;
  return *one_based ? Numbering::kFromOne : Numbering::kFromZero;
}

/// What of `pairs`, `vertices`, `triangles` and `barycentric` the file has, and whether its
/// numbering was `assumed`. Nearest vertices of points are added if the target is given.
py::dict read_map_file(const std::string& path, std::optional<int> source_vertices,
                       const GivenMesh& onto, std::optional<bool> one_based) {
  const std::optional<Mesh> target = given_mesh(onto);
  const MapChecks checks = checks_of(source_vertices, target);
  const auto numbering = numbering_of(one_based);
  MapReadReport report;
  py::dict result;
  if (lists_pairs(path)) {
    result["pairs"] = to_array(read_matches(path, checks, numbering, &report).matches);
  } else {
    MapContent map = read_map(path, checks, numbering, &report);
    if (map.source_to_target.empty() && target)
      map.source_to_target = nearest_vertices(*target, map.points);
    if (!map.source_to_target.empty()) result["vertices"] = adopt(std::move(map.source_to_target));
    if (!map.points.empty()) {
      auto [triangles, barycentric] = to_arrays(std::move(map.points));
      result["triangles"] = std::move(triangles);
      result["barycentric"] = std::move(barycentric);
    }
  }
  result["assumed"] = report.is_assumed;
  return result;
}

/// Adds the form of the map that is missing. Throws `InvalidInput` if it leads off the target.
void complete(MapContent& map, const Mesh& target) {
  const auto& [vertices, points] = map;
  check_map(vertices, static_cast<int>(vertices.size()), target.num_vertices());
  check_map(points, static_cast<int>(points.size()), target.num_faces());
  if (map.points.empty()) map.points = corner_points(target, map.source_to_target);
  if (map.source_to_target.empty()) map.source_to_target = nearest_vertices(target, map.points);
}

/// Writes a map of which `vertices`, `points` or both are given, with what the target adds.
void write_map_file(const std::string& path, const std::optional<py::array>& vertices,
                    const std::optional<std::pair<py::array, py::array>>& points,
                    const GivenMesh& onto, bool one_based) {
  MapContent map;
  if (vertices) map.source_to_target = to_integers(*vertices, "the map");
  if (points) map.points = to_surface_map(points->first, points->second);
  if (const std::optional<Mesh> target = given_mesh(onto)) complete(map, *target);
  const py::gil_scoped_release release;
  write_map(path, map, one_based ? Numbering::kFromOne : Numbering::kFromZero);
}

}  // namespace

void bind_maps(py::module_& module) {
  module.def("read_map", read_map_file);
  module.def("write_map", write_map_file);
  module.def("read_landmarks",
             [](const std::string& path, int source_vertices, int target_vertices) {
               return to_array(read_landmarks(path, {source_vertices, target_vertices}));
             });
}

}  // namespace isomatch::python
