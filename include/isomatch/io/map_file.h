// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"

/// Files of maps in the formats that others use, told apart by the ending:
/// - .txt, .map: the target vertex of each source vertex, one a line, or "unmatched", which is one
///   less than the first vertex;
/// - .vts: the same, always numbered from one; 0, "unmatched", is read, but written in
///   ground truths only;
/// - .bary.txt: for each source vertex a line with a target face and the barycentric weights of its
///   corners, or -1 0 0 0 where there is no point. Weights must be in [0, 1] and sum to 1, both
///   within 1e-6, and are returned as they are;
/// - .npz: arrays of numpy, always numbered from zero: `source_to_target` (N), and `triangles` (N)
///   with `barycentric` (N x 3); -1 where unmatched. The only array of N integers counts under
///   whatever name.
/// Text may hold blank lines, comments behind # and integers written as floats: numpy's `savetxt`
/// writes the latter two. What is read is 0-based in memory.
namespace isomatch {

/// The number that a file gives to a mesh's first vertex, and to its first face.
enum class Numbering { kFromZero = 0, kFromOne = 1 };

/// A map in one or both of its forms; a form that is not known is empty.
struct MapContent {
  VertexMap source_to_target{};
  SurfaceMap points{};
};

/// What a map is checked against, as far as it is known.
struct MapChecks {
  std::optional<int> source_vertices{}, target_vertices{}, target_faces{};
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
/// Throws `BadFile` that names the line if the file is missing, empty or malformed, of another
/// ending, or does not pass `checks`. O(N).
MapContent read_map(const std::string& path, const MapChecks& checks = {},
                    std::optional<Numbering> numbering = std::nullopt,
                    MapReadReport* report = nullptr);

/// What belongs together: pairs of vertices, or where the map leads to points on triangles, these;
/// an .npz file may have both.
struct MatchContent {
  Correspondence matches;
  SurfaceMap points;
};

/// Reads a map as `read_map`, or a list of pairs: a .txt or .map file whose first line has at least
/// two words, source vertex and target vertex; what follows them in a line is ignored. Without
/// `numbering`, pairs are taken as numbered from zero unless a number equals the number of its
/// shape's vertices and none is 0. Throws as `read_map`. O(N log N).
MatchContent read_matches(const std::string& path, const MapChecks& checks = {},
                          std::optional<Numbering> numbering = std::nullopt,
                          MapReadReport* report = nullptr);

/// Reads a ground truth: the vertex that stands for each template point, `kUnmatched` where the
/// mesh lacks the point, in any of the formats that hold a vertex a point, with their numbering;
/// commonly a .vts file, where 0 says so. Throws `BadFile` as `read_map`.
std::vector<int> read_ground_truth(const std::string& path, std::optional<int> num_vertices);

/// Writes the form of the map that the ending asks for, .npz both. `numbering` is that of .txt,
/// .map and .bary.txt files. The file appears whole or not at all, and survives a round trip
/// exactly. Throws `InvalidInput` if the form is not known, or if a .vts file is to hold what is
/// unmatched, whose 0 few programs know; `BadFile` if the file cannot be written.
void write_map(const std::string& path, const MapContent& map,
               Numbering numbering = Numbering::kFromZero);

/// Writes a ground truth that `read_ground_truth` reads: as `write_map`, but a .vts file has 0 for
/// `kUnmatched`. Throws as `write_map`.
void write_ground_truth(const std::string& path, const std::vector<int>& vertices);

/// Writes a match a line: source and target vertex, 0-based, and its distortion unless `d_iso` is
/// empty; `read_matches` gets the same matches. Throws `InvalidInput` if `d_iso` is neither empty
/// nor as long as `correspondence`, otherwise as `write_map`.
void write_correspondence(const std::string& path, const Correspondence& correspondence,
                          std::span<const double> d_iso = {});

/// The meshes' numbers of vertices.
struct VertexCounts {
  int source;
  int target;
};

/// Reads landmarks, in the file's order: a line each, source vertex and target vertex, and nothing
/// else; no source vertex occurs twice. Between the two are blanks, tabs, a comma or a semicolon; a
/// first line of names of columns, blank lines and comments behind # are passed over. Throws
/// `BadFile` as `read_map`.
std::vector<Match> read_landmarks(const std::string& path, VertexCounts counts,
                                  Numbering numbering = Numbering::kFromZero);

/// Reads a list of vertices, one a line, repeated or not, in the file's order. Without `numbering`
/// they are numbered from 0, or from 1 in a file named .vts. Throws `BadFile` as `read_map`.
std::vector<int> read_vertex_list(const std::string& path, int num_vertices,
                                  std::optional<Numbering> numbering = std::nullopt);

/// Whether `path` ends like a map.
bool is_map_file_name(const std::string& path);
/// Whether `path` ends like a file of points, .bary.txt.
bool is_point_map_file_name(const std::string& path);
/// Whether `path` ends like a file that numbers from one, .vts.
bool is_vts_file_name(const std::string& path);

/// Whether `path` is a text file whose first line is a pair, see `read_matches`. Throws `BadFile`
/// if it cannot be read.
bool lists_pairs(const std::string& path);

/// Throws the `BadFile` that `write_map` would throw because of `path` alone. Leaves no trace.
void check_map_output(const std::string& path);

}  // namespace isomatch
