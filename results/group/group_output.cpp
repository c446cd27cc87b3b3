// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/group_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "isomatch/error.h"
#include "results/group/group_arrays.h"
#include "results/group/group_meshes.h"
#include "results/group/group_tables.h"
#include "results/group/single_shapes.h"

namespace isomatch::results {
namespace {

void check_output(const GroupOutput& output) {
  check_shape_names(output.names);
  const std::size_t num_shapes = output.names.size();
  const std::size_t num_points = output.template_vertices.size();
  const auto fits = [&](const auto& points) { return points.size() == num_points; };
  const auto is_corner = [&](int p) { return p >= 0 && p < static_cast<int>(num_points); };
  const bool all_fit =
      output.points.points.size() == num_shapes &&
      std::ranges::all_of(output.points.points, fits) &&
      (output.points.present.empty() || output.points.present.size() == num_shapes) &&
      std::ranges::all_of(output.points.present, fits) && output.model.mean.size() == num_points &&
      output.model.aligned.rows() == static_cast<Eigen::Index>(num_shapes) &&
      std::ranges::all_of(output.faces,
                          [&](const Face& face) { return std::ranges::all_of(face, is_corner); }) &&
      std::ranges::all_of(output.columns, [&](const ShapeColumn& column) {
        return column.values.size() == num_shapes;
      });
  if (!all_fit) throw InvalidInput("the parts of a group's results do not fit");
}

}  // namespace

std::vector<Face> faces_between(const Mesh& mesh, const std::vector<int>& vertices) {
  std::unordered_map<int, int> place;
  for (std::size_t p = 0; p < vertices.size(); ++p) place[vertices[p]] = static_cast<int>(p);
  std::vector<Face> faces;
  for (Face face : mesh.faces) {
    if (!std::ranges::all_of(face, [&](int v) { return place.contains(v); })) continue;
    for (int& corner : face) corner = place[corner];
    faces.push_back(face);
  }
  return faces;
}

void check_shape_names(const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (name.empty() || name.find_first_of(std::string_view("/\0", 2)) != std::string::npos)
      throw InvalidInput(fmt::format("'{}' cannot be the name of a shape", name));
  std::vector<std::string> sorted = names;
  std::ranges::sort(sorted);
  const auto twice = std::ranges::adjacent_find(sorted);
  if (twice != sorted.end())
    throw InvalidInput(fmt::format("two shapes have the name '{}'", *twice));
}

std::vector<std::string> group_files(const std::vector<std::string>& names) {
  std::vector<std::string> files{"points.npz", "points.csv", "modes.npz", "scores.csv", "mean.ply"};
  for (int k = 0; k < kMostModeMeshes; ++k)
    files.insert(files.end(), {mode_mesh_name(k, -1), mode_mesh_name(k, 1)});
  for (const std::string& name : names)
    files.insert(files.end(), {shape_mesh_name(name), particles_name(name), landmarks_name(name)});
  return files;
}

void write_group(ResultFolder& folder, const GroupOutput& output) {
  check_output(output);
  write_point_arrays(folder.add("points.npz"), output);
  write_point_table(folder.add("points.csv"), output);
  write_mode_arrays(folder.add("modes.npz"), output);
  write_score_table(folder.add("scores.csv"), output);
  write_group_meshes(folder, output);
  write_single_shapes(folder, output);
}

}  // namespace isomatch::results
