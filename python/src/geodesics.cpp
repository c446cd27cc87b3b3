// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/geodesics/geodesics.h"

#include <fmt/format.h>

#include <numeric>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/error.h"
#include "options.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

void check_vertices(const Mesh& mesh, const std::vector<int>& vertices, const char* name) {
  for (const int vertex : vertices) {
    if (vertex < 0 || vertex >= mesh.num_vertices())
      throw InvalidInput(fmt::format("{}: vertex {} is out of range; there are {}", name, vertex,
                                     mesh.num_vertices()));
  }
}

py::array_t<float> distances(const py::array& vertices, const py::array& faces,
                             const py::array& sources, const py::dict& keywords,
                             const RunOptions& how) {
  const auto options = to_options<GeodesicOptions>(keywords);
  const Mesh mesh = to_mesh(vertices, faces);
  const std::vector<int> rows = to_integers(sources, "sources");
  check_vertices(mesh, rows, "sources");
  std::vector<float> fields = run(how, [&](const Context& context) {
    return geodesic_fields(GeodesicGraph(mesh, options, context), rows, context);
  });
  return adopt<float>(std::move(fields),
                      {static_cast<py::ssize_t>(rows.size()), mesh.num_vertices()});
}

double diameter(const py::array& vertices, const py::array& faces, const py::dict& keywords,
                const RunOptions& how) {
  const auto options = to_options<GeodesicOptions>(keywords);
  const Mesh mesh = to_mesh(vertices, faces);
  return run(how, [&](const Context& context) {
    return geodesic_diameter(GeodesicGraph(mesh, options, context), context);
  });
}

py::array_t<int> spread(const py::array& vertices, const py::array& faces, int count, int first,
                        const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<GeodesicOptions>(keywords);
  const Mesh mesh = to_mesh(vertices, faces);
  check_vertices(mesh, {first}, "first");
  return adopt(run(how, [&](const Context& context) {
    std::vector<int> candidates(mesh.vertices.size());
    std::iota(candidates.begin(), candidates.end(), 0);
    return farthest_points(GeodesicGraph(mesh, options, context), candidates, count, first);
  }));
}

}  // namespace

void bind_geodesics(py::module_& module) {
  register_options<GeodesicOptions>(module, "geodesics");
  module.def("geodesic_distances", distances);
  module.def("geodesic_diameter", diameter);
  module.def("farthest_points", spread);
}

}  // namespace isomatch::python
