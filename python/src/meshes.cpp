// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/io/mesh_io.h"
#include "results/json.h"
#include "results/loaded_mesh.h"
#include "results/option_names.h"
#include "run.h"
#include "shapes.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

std::shared_ptr<MatchInput> loaded(const std::string& path, Mesh mesh, MeshReadReport report,
                                   const std::string& geodesics) {
  Shape shape = results::shape_of(path, std::move(mesh), results::geodesic_options(geodesics));
  return std::make_shared<MatchInput>(path, std::move(report), std::move(shape));
}

std::shared_ptr<MatchInput> load_shape(const std::string& path, const std::string& geodesics,
                                       const RunOptions& how) {
  return run(how, [&](const Context& context) {
    MeshReadReport report;
    Mesh mesh = read_mesh(path, &report);
    context.check_stop();
    return loaded(path, std::move(mesh), std::move(report), geodesics);
  });
}

std::shared_ptr<MatchInput> make_shape(const py::array& vertices, const py::array& faces,
                                       const std::string& geodesics, const RunOptions& how) {
  Mesh mesh = to_mesh(vertices, faces);
  return run(how, [&](const Context&) {
    return std::make_shared<MatchInput>(
        std::string(), MeshReadReport(),
        Shape(std::move(mesh), results::geodesic_options(geodesics)));
  });
}

/// What reading the file told; with path and arrays it makes the shape anew.
py::tuple read_report(const MatchInput& mesh) {
  const auto& [polygons, merged, warnings, names] = mesh.read_report;
  return py::make_tuple(polygons, merged, warnings, names);
}

std::shared_ptr<MatchInput> restore_shape(const std::string& path, const py::array& vertices,
                                          const py::array& faces, const py::tuple& report,
                                          const std::string& geodesics) {
  Mesh mesh = to_mesh(vertices, faces);
  MeshReadReport read{report[0].cast<int>(), report[1].cast<int>(),
                      report[2].cast<std::vector<std::string>>(),
                      report[3].cast<std::vector<std::string>>()};
  const py::gil_scoped_release release;
  return loaded(path, std::move(mesh), std::move(read), geodesics);
}

double max_geodesic(const MatchInput& mesh) {
  return run({py::none(), py::none()},
             [&](const Context& context) { return mesh.shape.max_geodesic(context); });
}

py::tuple read_mesh_file(const std::string& path) {
  Mesh mesh;
  {
    const py::gil_scoped_release release;
    mesh = read_mesh(path);
  }
  return py::make_tuple(to_array(std::move(mesh.vertices)), to_array(std::move(mesh.faces)));
}

void write_mesh_file(const std::string& path, const py::array& vertices, const py::array& faces) {
  const Mesh mesh = to_mesh(vertices, faces);
  const py::gil_scoped_release release;
  write_mesh(path, mesh);
}

}  // namespace

void bind_meshes(py::module_& module) {
  py::class_<RunOptions>(module, "RunOptions")
      .def(py::init<py::object, py::object>(), py::arg("threads"), py::arg("progress"));
  py::class_<MatchInput, std::shared_ptr<MatchInput>>(module, "Shape")
      .def_property_readonly("path", [](const MatchInput& shape) { return py::bytes(shape.path); })
      .def_property_readonly(
          "vertices", [](const MatchInput& shape) { return to_array(shape.mesh().vertices); })
      .def_property_readonly("faces",
                             [](const MatchInput& shape) { return to_array(shape.mesh().faces); })
      .def_property_readonly("area", [](const MatchInput& shape) { return shape.shape.area(); })
      .def_property_readonly("max_geodesic",
                             [](const MatchInput& shape) { return max_geodesic(shape); })
      .def_property_readonly("on_surface",
                             [](const MatchInput& shape) {
                               py::array_t<bool> result(shape.mesh().num_vertices());
                               for (int v = 0; v < shape.mesh().num_vertices(); ++v)
                                 result.mutable_at(v) = shape.shape.on_surface(v);
                               return result;
                             })
      .def_property_readonly("warnings",
                             [](const MatchInput& shape) {
                               std::vector<std::string> warnings = shape.read_report.warnings;
                               const std::vector<std::string> defects =
                                   shape.shape.diagnosis().warnings();
                               warnings.insert(warnings.end(), defects.begin(), defects.end());
                               return warnings;
                             })
      .def_property_readonly("urgent_warnings",
                             [](const MatchInput& shape) {
                               std::vector<std::string> warnings = shape.read_report.warnings;
                               std::ranges::copy(shape.shape.diagnosis().grave_warnings(),
                                                 std::back_inserter(warnings));
                               return warnings;
                             })
      .def_property_readonly("read_report", read_report)
      .def("diagnosis_json", [](const MatchInput& shape) {
        return results::to_json(shape.shape.diagnosis()).dump();
      });
  module.def("load_shape", load_shape);
  module.def("make_shape", make_shape);
  module.def("restore_shape", restore_shape, py::arg("path"), py::arg("vertices"), py::arg("faces"),
             py::arg("read_report"), py::arg("geodesics"));
  module.def("read_mesh", read_mesh_file);
  module.def("write_mesh", write_mesh_file);
}

}  // namespace isomatch::python
