// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "textures.h"

#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/error.h"
#include "isomatch/io/material_libraries.h"
#include "isomatch/io/model_io.h"
#include "results/files/outputs.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

py::array array(const py::tuple& parts, std::size_t number) {
  return parts[number].cast<py::array>();
}

VertexColors to_colors(const py::array& rows) {
  const std::vector<Point> points = to_points(rows, "colors");
  return {points.begin(), points.end()};
}

/// Other formats have no room for what is to be written.
void check_ending(const std::string& path, const std::string& ending) {
  if (results::lower_ending(path) != ending)
    throw BadFile(path, "must be a file named " + ending + " here");
}

py::dict read_textured_file(const std::string& path) {
  TexturedMesh textured;
  {
    const py::gil_scoped_release release;
    textured = read_textured_mesh(path);
  }
  return to_dict(std::move(textured));
}

void write_textured_file(const std::string& path, const py::tuple& parts,
                         const std::string& library) {
  TexturedMesh textured = to_textured(parts);
  const py::gil_scoped_release release;
  check_ending(path, ".obj");
  ModelWriteOptions options;
  if (!library.empty()) options.material_libraries = {library};
  write_model(path, {.mesh = std::move(textured.mesh), .texture = std::move(textured.texture)},
              options);
}

void write_colored_file(const std::string& path, const py::array& vertices, const py::array& faces,
                        const py::array& colors) {
  Model model{.mesh = to_mesh(vertices, faces), .colors = to_colors(colors)};
  check_ending(path, ".ply");
  // Without any, a model would be written as it is.
  if (model.colors.size() != model.mesh.vertices.size())
    throw InvalidInput("write_colored_mesh needs a colour for every vertex");
  write_model(path, model);
}

}  // namespace

TexturedMesh to_textured(const py::tuple& parts) {
  TexturedMesh textured;
  textured.mesh = to_mesh(array(parts, 0), array(parts, 1));
  Texture& texture = textured.texture;
  const Doubles coordinates = to_doubles(array(parts, 2), "coordinates", 2);
  for (py::ssize_t i = 0; i < coordinates.shape(0); ++i)
    texture.coordinates.emplace_back(coordinates.at(i, 0), coordinates.at(i, 1));
  const std::vector<int> corners = to_integers(array(parts, 3), "corners", 3);
  for (std::size_t i = 0; i < corners.size(); i += 3)
    texture.corners.push_back({corners[i], corners[i + 1], corners[i + 2]});
  texture.materials = parts[4].cast<std::vector<std::string>>();
  texture.face_material = to_integers(array(parts, 5), "face_material");
  validate(texture, textured.mesh);
  return textured;
}

py::dict to_dict(TexturedMesh textured) {
  Texture& texture = textured.texture;
  const auto count = static_cast<py::ssize_t>(texture.coordinates.size());
  py::dict result;
  result["vertices"] = to_array(std::move(textured.mesh.vertices));
  result["faces"] = to_array(std::move(textured.mesh.faces));
  result["coordinates"] = adopt<double>(std::move(texture.coordinates), {count, 2});
  result["corners"] = to_array(std::move(texture.corners));
  result["materials"] = texture.materials;
  result["face_material"] = adopt(std::move(texture.face_material));
  return result;
}

void bind_textures(py::module_& module) {
  module.def("read_textured_mesh", read_textured_file);
  module.def("write_textured_mesh", write_textured_file);
  module.def("material_libraries", [](const std::string& path) {
    py::list names;
    for (const std::string& name : material_libraries(path)) names.append(py::bytes(name));
    return names;
  });
  module.def("read_vertex_colors",
             [](const std::string& path) { return to_array(read_vertex_colors(path)); });
  module.def("write_colored_mesh", write_colored_file);
}

}  // namespace isomatch::python
