// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/diagnosis.h"
#include "isomatch/mesh/shape.h"
#include "results/folder/inputs.h"

namespace isomatch::python {

/// A mesh and what every stage needs to know about it. Safe to share by threads.
class PreparedMesh {
 public:
  /// A mesh without a file, with the geodesics that the program calls `geodesics`. Throws
  /// `InvalidInput`.
  PreparedMesh(Mesh mesh, const std::string& geodesics);
  /// A mesh that was read from `path`. What makes it unusable is a `BadFile`.
  PreparedMesh(const std::string& path, Mesh mesh, const MeshReadReport& read_report,
               const std::string& geodesics);

  /// The mesh in the form in which the program has it, with an empty path if there is no file.
  const results::MatchInput& input() const { return input_; }
  const Mesh& mesh() const { return input_.mesh; }
  const Surface& surface() const { return input_.surface; }
  /// Prepared when it is asked for, once.
  const Shape& shape(const Context& context) const;

 private:
  results::MatchInput input_;
  GeodesicOptions geodesics_;
  mutable std::mutex preparing_;
  mutable std::optional<Shape> shape_;
};

/// Both meshes in the form in which the program has them.
results::MatchInputs to_inputs(const PreparedMesh& source, const PreparedMesh& target);

/// `values` of the surface's vertices for every vertex of the mesh, NaN where it is not part of the
/// surface.
std::vector<double> input_values(const Surface& surface, std::span<const double> values);

/// Surface vertices as those of the mesh.
std::vector<int> input_numbers(const Surface& surface, std::span<const int> vertices);

/// Vertices of the mesh as those of the surface. Throws `InvalidInput` that begins with `name` if
/// one is out of range or not part of the surface.
std::vector<int> surface_numbers(const Surface& surface, std::span<const int> vertices,
                                 const char* name);

/// Throws `InvalidInput` that begins with `name` unless `vertex` is one of `count`.
void check_vertex(int vertex, std::size_t count, const char* name);

/// Throws `InvalidInput` unless `map` has a point, or none, on `onto` for each vertex of `from`.
void check_map(const PreparedMesh& from, const PreparedMesh& onto, const SurfaceMap& map);

/// Throws `InvalidInput` if a match names a vertex that the meshes do not have.
void check_matches(const PreparedMesh& source, const PreparedMesh& target,
                   std::span<const Match> matches);

}  // namespace isomatch::python
