// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "prepared.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "results/loaded_mesh.h"

namespace isomatch::python {
namespace {

GeodesicOptions geodesic_options(const std::string& name) {
  if (name == "edges") return GeodesicOptions::edges();
  if (name == "w10") return GeodesicOptions::w10();
  if (name == "w20") return GeodesicOptions::w20();
  throw InvalidInput("geodesics: expected w20, w10 or edges, not " + name);
}

}  // namespace

PreparedMesh::PreparedMesh(Mesh mesh, const std::string& geodesics)
    : input_{{}, std::move(mesh), {}, {}, {}}, geodesics_(geodesic_options(geodesics)) {
  Inspection inspection = inspect(input_.mesh);
  if (!inspection.surface) throw InvalidInput("the mesh has no face of positive area");
  input_.diagnosis = inspection.diagnosis;
  input_.surface = std::move(*inspection.surface);
}

PreparedMesh::PreparedMesh(const std::string& path, Mesh mesh, const MeshReadReport& read_report,
                           const std::string& geodesics)
    : input_{path, std::move(mesh), read_report, {}, {}}, geodesics_(geodesic_options(geodesics)) {
  Inspection inspection = results::inspected(path, input_.mesh);
  input_.diagnosis = inspection.diagnosis;
  input_.surface = std::move(*inspection.surface);
}

const Shape& PreparedMesh::shape(const Context& context) const {
  const std::lock_guard lock(preparing_);
  if (!shape_) shape_ = prepare_shape(input_.surface, geodesics_, context);
  return *shape_;
}

results::MatchInputs to_inputs(const PreparedMesh& source, const PreparedMesh& target) {
  return {{}, std::filesystem::current_path().string(), source.input(), target.input(), {}};
}

std::vector<double> input_values(const Surface& surface, std::span<const double> values) {
  std::vector<double> result(surface.surface_vertex.size(),
                             std::numeric_limits<double>::quiet_NaN());
  for (std::size_t v = 0; v < result.size(); ++v) {
    if (surface.surface_vertex[v] != kNoVertex) result[v] = values[surface.surface_vertex[v]];
  }
  return result;
}

std::vector<int> input_numbers(const Surface& surface, std::span<const int> vertices) {
  std::vector<int> result;
  for (const int vertex : vertices) result.push_back(surface.input_vertex[vertex]);
  return result;
}

std::vector<int> surface_numbers(const Surface& surface, std::span<const int> vertices,
                                 const char* name) {
  std::vector<int> result;
  for (const int vertex : vertices) {
    check_vertex(vertex, surface.surface_vertex.size(), name);
    result.push_back(surface.surface_vertex[vertex]);
    if (result.back() == kNoVertex)
      throw InvalidInput(
          fmt::format("{}: vertex {} is not on the surface that is matched", name, vertex));
  }
  return result;
}

void check_vertex(int vertex, std::size_t count, const char* name) {
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= count)
    throw InvalidInput(
        fmt::format("{}: vertex {} is out of range; there are {}", name, vertex, count));
}

void check_map(const PreparedMesh& from, const PreparedMesh& onto, const SurfaceMap& map) {
  if (std::cmp_not_equal(map.size(), from.mesh().num_vertices()))
    throw InvalidInput(fmt::format("the map has {} points, but the mesh {} vertices", map.size(),
                                   from.mesh().num_vertices()));
  for (const SurfacePoint& point : map) {
    if (point.face < kNoFace || point.face >= onto.mesh().num_faces())
      throw InvalidInput(fmt::format("triangles: face {} is out of range; there are {}", point.face,
                                     onto.mesh().num_faces()));
  }
}

void check_matches(const PreparedMesh& source, const PreparedMesh& target,
                   std::span<const Match> matches) {
  for (const Match& match : matches) {
    check_vertex(match.source, source.mesh().vertices.size(), "source");
    check_vertex(match.target, target.mesh().vertices.size(), "target");
  }
}

}  // namespace isomatch::python
