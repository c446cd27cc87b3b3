// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/group_meshes.h"

#include <fmt/format.h>

#include <algorithm>

#include "isomatch/io/mesh_io.h"

namespace isomatch::results {
namespace {

std::vector<Face> faces_of_shape(const GroupOutput& output, std::size_t i) {
  std::vector<Face> faces;
  for (const Face& face : output.faces)
    if (std::ranges::all_of(face, [&](int p) { return output.points.has(i, p); }))
      faces.push_back(face);
  return faces;
}

}  // namespace

std::string shape_mesh_name(const std::string& shape) { return "meshes/" + shape + ".ply"; }

std::string mode_mesh_name(int mode, int side) {
  return fmt::format("modes/mode_{}_{}_2sd.ply", mode + 1, side < 0 ? "minus" : "plus");
}

void write_group_meshes(ResultFolder& folder, const GroupOutput& output) {
  if (output.faces.empty()) return;
  for (std::size_t i = 0; i < output.names.size(); ++i) {
    const Mesh mesh{completed_points(output.points, output.model, static_cast<int>(i)),
                    faces_of_shape(output, i)};
    if (!mesh.faces.empty()) write_mesh(folder.add(shape_mesh_name(output.names[i])), mesh);
  }
  write_mesh(folder.add("mean.ply"), {output.model.mean, output.faces});
  const int num_modes = std::min(kMostModeMeshes, static_cast<int>(output.model.modes.rows()));
  for (int k = 0; k < num_modes; ++k)
    for (const int side : {-1, 1}) {
      std::vector<double> deviations(k + 1, 0.0);
      deviations.back() = 2 * side;
      write_mesh(folder.add(mode_mesh_name(k, side)),
                 {output.model.shape_at(deviations), output.faces});
    }
}

}  // namespace isomatch::results
