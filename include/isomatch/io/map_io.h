// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <string>
#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"

namespace isomatch {

/// The number that a file gives to a mesh's first vertex. What stands for "unmatched" in a map is
/// one less.
enum class Numbering { kFromZero = 0, kFromOne = 1 };

/// The meshes' numbers of vertices, against which a file is checked.
struct VertexCounts {
  int source;
  int target;
};

/// Reads a correspondence from a text file in either of two forms, told apart by the first line.
/// A map has one word a line: the target vertex of each source vertex in order, or "unmatched". A
/// list of pairs has at least two words a line: source vertex and target vertex; what follows them
/// is ignored. Blank lines are passed over. The result is 0-based. Throws `BadFile` that names the
/// line if the file is missing, empty or malformed, a vertex is out of range, or a map's length is
/// not the number of source vertices. O(N log N).
Correspondence read_correspondence(const std::string& path, VertexCounts counts,
                                   Numbering numbering = Numbering::kFromZero);

/// Reads a map as above, and nothing else.
VertexMap read_source_to_target(const std::string& path, VertexCounts counts,
                                Numbering numbering = Numbering::kFromZero);

/// Reads landmarks, in the file's order: a line each, source vertex and target vertex, and nothing
/// else; no source vertex occurs twice. Between the two are blanks, tabs, a comma or a semicolon; a
/// first line of names of columns, blank lines and comments behind # are passed over. The result is
/// 0-based. Throws `BadFile` as `read_correspondence`.
std::vector<Match> read_landmarks(const std::string& path, VertexCounts counts,
                                  Numbering numbering = Numbering::kFromZero);

/// Reads a list of vertices, one a line, repeated or not, numbered from 0, or from 1 in a file
/// named .vts. In the file's order.
std::vector<int> read_vertex_list(const std::string& path, int num_vertices);

/// What a file of points on a target is checked against.
struct SurfaceMapCounts {
  int source_vertices;
  int target_faces;
};

/// Reads a .bary.txt file: for each source vertex in order a line with a target face and the
/// barycentric weights of its corners, or -1 0 0 0 where there is no point. Weights must be in
/// [0, 1] and sum to 1, both within 1e-6, and are returned as they are. `numbering` is that of
/// faces. The result is 0-based. Throws `BadFile` as `read_correspondence`.
SurfaceMap read_surface_map(const std::string& path, SurfaceMapCounts counts,
                            Numbering numbering = Numbering::kFromZero);

/// Reads a .vts file: line i holds the vertex, numbered from one, that stands for template point i.
/// The result is 0-based. Throws `BadFile` as `read_correspondence`.
std::vector<int> read_vts(const std::string& path, int num_vertices);

/// Writes the 0-based target vertex of each source vertex, one a line, -1 where unmatched. The file
/// appears whole or not at all. Throws `BadFile` if it cannot be written.
void write_source_to_target(const std::string& path, const VertexMap& source_to_target);

/// Writes a match a line: source and target vertex, 0-based, and its distortion unless `d_iso` is
/// empty; it survives a round trip exactly. Throws `InvalidInput` if `d_iso` is neither empty nor
/// as long as `correspondence`, otherwise as `write_source_to_target`.
void write_correspondence(const std::string& path, const Correspondence& correspondence,
                          std::span<const double> d_iso = {});

/// Writes a .bary.txt file, 0-based. It survives a round trip exactly.
void write_surface_map(const std::string& path, const SurfaceMap& map);

/// Writes a .vts file of 0-based `vertices`, one for each template point.
void write_vts(const std::string& path, const std::vector<int>& vertices);

}  // namespace isomatch
