// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/mesh.h"
#include "results/files/input_files.h"
#include "results/json.h"

namespace isomatch::results {

/// One map of a result folder, in the numbers of the input files.
struct ResultMap {
  /// Below the result folder; empty for the best map.
  std::string folder;
  /// The nearest target vertex of every source vertex, `kUnmatched` where there is none.
  VertexMap source_to_target;
  /// A point on the target for every source vertex. A map to vertices leads to corners of faces.
  SurfaceMap points;
  /// The source's vertices in the target's pose; empty if the method does not register.
  std::vector<Point> registered;
  /// How sure the points of the vertices are, in [0, 1]; empty if the folder does not tell.
  std::vector<float> source_confidence = {}, target_confidence = {};

  bool is_matched(int source_vertex) const { return points[source_vertex].face >= 0; }
};

/// What `isomatch match` left in a folder, and the meshes it was made of.
struct MatchResult {
  std::string folder;
  /// report.json.
  Json report;
  /// Where the meshes were found.
  std::string source_path, target_path;
  Mesh source, target;
  /// The best map, then the alternatives.
  std::vector<ResultMap> maps;

  std::string path(const std::string& name) const;
};

/// Where to look for the meshes, instead of where they were; empty for that.
struct MeshPlaces {
  std::string source, target;
};

/// The files that `load_result` reads and what else belongs to them: all that the match wrote but
/// the page, and the meshes with their materials and images. Throws `BadFile` if the report or a
/// mesh is missing.
InputFiles result_inputs(const std::string& folder, const MeshPlaces& places = {});

/// Reads a result folder. Meshes are looked for under the names they were given by, from the
/// current folder and then from the one in which the match was run. Throws `BadFile` if something
/// is missing, malformed, or a mesh is not the one that was matched.
MatchResult load_result(const std::string& folder, const MeshPlaces& places = {});

/// The many-to-many relation of the best map of a folder. Throws `BadFile`.
Correspondence load_relation(const MatchResult& result);

/// The best map, or an alternative, counted from one. Throws `BadFile` if there is none.
const ResultMap& chosen_map(const MatchResult& result, std::size_t alternative);

/// Where each source vertex lands; the origin where it is unmatched.
std::vector<Point> images(const Mesh& target, const ResultMap& map);

}  // namespace isomatch::results
