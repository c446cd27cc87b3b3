// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.h"
#include "isomatch/io/mesh_io.h"
#include "load.h"
#include "results/json.h"
#include "results/loaded_mesh.h"

namespace isomatch::cli {
namespace {

struct InfoArguments {
  std::string mesh;
  MeshReadOptions reading;
  bool json = false;
};

template <class Value>
void print_line(std::string_view name, const Value& value) {
  fmt::print("  {:<24}{}\n", name, value);
}

std::string describe(const std::optional<int>& genus) {
  return genus ? std::to_string(*genus) : "none: not an orientable manifold";
}

/// Only the first of many.
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  const auto shown = static_cast<std::ptrdiff_t>(std::min(names.size(), kMost));
  const std::string list = fmt::format("{}", fmt::join(names.begin(), names.begin() + shown, ", "));
  return names.size() > kMost ? fmt::format("{} and {} more", list, names.size() - kMost) : list;
}

void print_mesh(const MeshDiagnosis& diagnosis, const MeshReadReport& report) {
  print_line("vertices", diagnosis.vertices);
  print_line("faces", diagnosis.faces);
  print_line("area", diagnosis.area);
  print_line("components", diagnosis.components);
  if (report.meshes.size() > 1) print_line("meshes read as one", listed(report.meshes));
  if (report.triangulated_polygons > 0)
    print_line("polygons triangulated", report.triangulated_polygons);
  if (report.merged_vertices > 0) print_line("STL corners merged", report.merged_vertices);
}

void print_surface(const MeshDiagnosis& diagnosis) {
  const Connectivity& surface = diagnosis.surface;
  fmt::print("surface that is matched\n");
  print_line("vertices", surface.vertices);
  print_line("faces", surface.faces);
  print_line("share of area", fmt::format("{:.1f} %", 100 * diagnosis.matchable_area_share));
  print_line("edge length", fmt::format("{:.4g} to {:.4g}, mean {:.4g}", diagnosis.min_edge,
                                        diagnosis.max_edge, diagnosis.mean_edge));
  print_line("boundary loops", surface.boundary_loops);
  print_line("genus", describe(surface.genus()));
}

void run_info(const InfoArguments& arguments) {
  MeshReadReport report;
  const Mesh mesh = read_mesh(arguments.mesh, &report, arguments.reading);
  for (const std::string& warning : report.warnings) warn_of(arguments.mesh, warning);
  const MeshDiagnosis diagnosis = results::diagnosed(arguments.mesh, mesh);
  if (arguments.json) {
    results::Json json = results::to_json(diagnosis);
    json["triangulated_polygons"] = report.triangulated_polygons;
    json["merged_vertices"] = report.merged_vertices;
    json["read_warnings"] = report.warnings;
    json["meshes"] = report.meshes;
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{}\n", arguments.mesh);
  print_mesh(diagnosis, report);
  print_surface(diagnosis);
  for (const std::string& warning : diagnosis.warnings()) fmt::print("! {}\n", warning);
}

}  // namespace

void add_info(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App& command = *app.add_subcommand("info", "Print what a mesh is made of and its defects");
  command.add_option("MESH", arguments->mesh, "OFF, OBJ, PLY, STL, GLB, glTF or MAT file")
      ->required();
  add_mesh_option(command, arguments->reading);
  command.add_flag("--json", arguments->json, "Print JSON");
  set_example(command, "isomatch info horse.off", "meshes.md");
  command.callback([arguments, &request] {
    request.action = [arguments](const Context&) { run_info(*arguments); };
  });
}

}  // namespace isomatch::cli
