// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/io/mesh_io.h"
#include "prepared.h"
#include "results/json.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

std::shared_ptr<PreparedMesh> load_shape(const std::string& path, const std::string& geodesics,
                                         const RunOptions& how) {
  return run(how, [&](const Context& context) {
    MeshReadReport report;
    Mesh mesh = read_mesh(path, &report);
    context.check_stop();
    return std::make_shared<PreparedMesh>(path, std::move(mesh), report, geodesics);
  });
}

std::shared_ptr<PreparedMesh> make_shape(const py::array& vertices, const py::array& faces,
                                         const std::string& geodesics, const RunOptions& how) {
  Mesh mesh = to_mesh(vertices, faces);
  return run(how, [&](const Context&) {
    return std::make_shared<PreparedMesh>(std::move(mesh), geodesics);
  });
}

/// What reading the file told; with path and arrays it makes the shape anew.
py::tuple read_report(const PreparedMesh& mesh) {
  const auto& [polygons, merged, warnings, names] = mesh.input().read_report;
  return py::make_tuple(polygons, merged, warnings, names);
}

std::shared_ptr<PreparedMesh> restore_shape(const std::string& path, const py::array& vertices,
                                            const py::array& faces, const py::tuple& report,
                                            const std::string& geodesics) {
  Mesh mesh = to_mesh(vertices, faces);
  const MeshReadReport read{report[0].cast<int>(), report[1].cast<int>(),
                            report[2].cast<std::vector<std::string>>(),
                            report[3].cast<std::vector<std::string>>()};
  const py::gil_scoped_release release;
  return std::make_shared<PreparedMesh>(path, std::move(mesh), read, geodesics);
}

double max_geodesic(const PreparedMesh& mesh) {
  return run({py::none(), py::none()}, [&](const Context& context) {
    const Shape& shape = mesh.shape(context);
    return shape.unit * shape.max_geodesic;
  });
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
  py::class_<PreparedMesh, std::shared_ptr<PreparedMesh>>(module, "Shape")
      .def_property_readonly(
          "path", [](const PreparedMesh& shape) { return py::bytes(shape.input().path); })
      .def_property_readonly(
          "vertices", [](const PreparedMesh& shape) { return to_array(shape.mesh().vertices); })
      .def_property_readonly("faces",
                             [](const PreparedMesh& shape) { return to_array(shape.mesh().faces); })
      .def_property_readonly("area", [](const PreparedMesh& shape) { return shape.surface().area; })
      .def_property_readonly("max_geodesic",
                             [](const PreparedMesh& shape) { return max_geodesic(shape); })
      .def_property_readonly("on_surface",
                             [](const PreparedMesh& shape) {
                               py::array_t<bool> result(shape.mesh().num_vertices());
                               for (int v = 0; v < shape.mesh().num_vertices(); ++v)
                                 result.mutable_at(v) =
                                     shape.surface().surface_vertex[v] != kNoVertex;
                               return result;
                             })
      .def_property_readonly(
          "warnings",
          [](const PreparedMesh& shape) {
            std::vector<std::string> warnings = shape.input().read_report.warnings;
            const std::vector<std::string> defects = shape.input().diagnosis.warnings();
            warnings.insert(warnings.end(), defects.begin(), defects.end());
            return warnings;
          })
      .def_property_readonly("urgent_warnings",
                             [](const PreparedMesh& shape) {
                               std::vector<std::string> warnings =
                                   shape.input().read_report.warnings;
                               std::ranges::copy(shape.input().diagnosis.grave_warnings(),
                                                 std::back_inserter(warnings));
                               return warnings;
                             })
      .def_property_readonly("read_report", read_report)
      .def("diagnosis_json", [](const PreparedMesh& shape) {
        return results::to_json(shape.input().diagnosis).dump();
      });
  module.def("load_shape", load_shape);
  module.def("make_shape", make_shape);
  module.def("restore_shape", restore_shape, py::arg("path"), py::arg("vertices"), py::arg("faces"),
             py::arg("read_report"), py::arg("geodesics"));
  module.def("read_mesh", read_mesh_file);
  module.def("write_mesh", write_mesh_file);
}

}  // namespace isomatch::python
