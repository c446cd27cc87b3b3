// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/mesh_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

#include "io/mesh/formats.h"
#include "io/mesh/polygon.h"
#include "io/text_cursor.h"
#include "isomatch/error.h"

namespace isomatch {
namespace {

using mesh_io::read_only_mesh;

struct Format {
  std::string_view ending;
  mesh_io::ReadResult (*read)(const InputFile&, const MeshReadOptions&);
  /// Null where there is no writer.
  void (*write)(const Mesh&, AtomicFile&);
};

constexpr std::array<Format, 7> kFormats = {
    {{".off", read_only_mesh<mesh_io::read_off>, mesh_io::write_off},
     {".obj", read_only_mesh<mesh_io::read_obj>, mesh_io::write_obj},
     {".ply", read_only_mesh<mesh_io::read_ply>, mesh_io::write_ply},
     {".glb", mesh_io::read_gltf, mesh_io::write_glb},
     {".gltf", mesh_io::read_gltf, mesh_io::write_gltf},
     {".mat", read_only_mesh<mesh_io::read_mat>, mesh_io::write_mat},
     {".stl", read_only_mesh<mesh_io::read_stl>, nullptr}}};

const Format* find_format(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto found = std::ranges::find_if(
      kFormats, [&](const Format& format) { return equal_ignoring_case(format.ending, ending); });
  return found == kFormats.end() ? nullptr : &*found;
}

const Format& format_of(const std::string& path) {
  if (const Format* format = find_format(path)) return *format;
  std::string endings;
  for (const Format& format : kFormats) endings += fmt::format(" {}", format.ending);
  throw BadFile(path,
                fmt::format("the ending {} is not that of a mesh file:{}",
                            in_quotes(std::filesystem::path(path).extension().string()), endings));
}

const Format& writable_format_of(const std::string& path) {
  const Format& format = format_of(path);
  if (!format.write)
    throw BadFile(path, "STL files are only read; write .off, .obj, .ply, .glb, .gltf or .mat");
  return format;
}

}  // namespace

namespace mesh_io {

void complete(ReadResult& result, const InputFile& file) {
  const Mesh& mesh = result.mesh;
  constexpr std::size_t kMost = std::numeric_limits<int>::max();
  if (mesh.vertices.empty()) file.fail("the mesh has no vertices");
  if (mesh.faces.empty()) file.fail("the mesh has no faces");
  if (std::max(mesh.vertices.size(), mesh.faces.size()) > kMost)
    file.fail("the mesh has more vertices or triangles than this program can number");
  cut_polygons(result);
  if (result.short_faces > 0)
    result.report.warnings.push_back(
        fmt::format("faces of fewer than three corners, left out: {}", result.short_faces));
}

}  // namespace mesh_io

bool is_mesh_file_name(const std::string& path) { return find_format(path) != nullptr; }

Mesh read_mesh(const std::string& path, MeshReadReport* report, const MeshReadOptions& options) {
  // A file that is missing is told as such, whatever its name.
  const InputFile file(path);
  const Format& format = format_of(path);
  mesh_io::ReadResult result = format.read(file, options);
  mesh_io::complete(result, file);
  if (report) *report = std::move(result.report);
  return std::move(result.mesh);
}

void check_mesh_output(const std::string& path) {
  writable_format_of(path);
  const AtomicFile attempt(path);
}

void write_mesh(const std::string& path, const Mesh& mesh) {
  const Format& format = writable_format_of(path);
  validate(mesh);
  AtomicFile file(path);
  format.write(mesh, file);
  file.commit();
}

}  // namespace isomatch
