// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>

#include "isomatch/correspondence.h"
#include "isomatch/map_io.h"
#include "isomatch/surface_map.h"

/// Files of maps in the formats that others use, told apart by the ending:
/// - .txt, .map: the target vertex of each source vertex, one a line;
/// - .vts: the same, always numbered from one;
/// - .bary.txt: target face and barycentric weights, see `read_surface_map`;
/// - .npz: arrays of numpy, always numbered from zero: `source_to_target` (N), and `triangles` (N)
///   with `barycentric` (N x 3); -1 where unmatched. The only array of N integers counts under
///   whatever name.
namespace isomatch {

/// A map in one or both of its forms; a form that is not known is empty.
struct MapContent {
  VertexMap source_to_target;
  SurfaceMap points;
};

/// What a map is checked against, as far as it is known.
struct MapChecks {
  std::optional<int> source_vertices, target_vertices, target_faces;
};

/// What a reader found out about a file.
struct MapReadReport {
  Numbering numbering = Numbering::kFromZero;
  /// Nothing in the file speaks for `numbering` or against it.
  bool is_assumed = false;
};

/// Reads a map and reports to `report`, unless it is null.
///
/// Without `numbering`, a .txt or .map file is taken as numbered from zero, unless that cannot be:
/// a number equals `checks.target_vertices` and none is -1. So pass the number of target vertices,
/// or the numbering, where it may be from one. .vts and .npz files need neither, and a .bary.txt
/// file is numbered from zero unless told otherwise.
///
/// Throws `BadFile` if the file is missing, malformed, of another ending, or does not pass
/// `checks`. O(N).
MapContent read_map(const std::string& path, const MapChecks& checks = {},
                    std::optional<Numbering> numbering = std::nullopt,
                    MapReadReport* report = nullptr);

/// Writes the form of the map that the ending asks for, .npz both. `numbering` is that of .txt,
/// .map and .bary.txt files. The file appears whole or not at all, and survives a round trip
/// exactly. Throws `InvalidInput` if the form is not known, or if a .vts file is to hold what is
/// unmatched, for which it has no word; `BadFile` if the file cannot be written.
void write_map(const std::string& path, const MapContent& map,
               Numbering numbering = Numbering::kFromZero);

/// Whether `path` ends like a map.
bool is_map_file_name(const std::string& path);
/// Whether `path` ends like a file of points, .bary.txt.
bool is_point_map_file_name(const std::string& path);

/// Throws the `BadFile` that `write_map` would throw because of `path` alone. Leaves no trace.
void check_map_output(const std::string& path);

}  // namespace isomatch
