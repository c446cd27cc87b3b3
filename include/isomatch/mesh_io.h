// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "isomatch/mesh.h"

namespace isomatch {

/// What a reader had to do to make an indexed triangle mesh of a file.
struct MeshReadReport {
  /// Polygons of more than three corners that were cut into triangle fans.
  int triangulated_polygons = 0;
  /// STL only: corners of triangles that were merged because their positions are equal.
  int merged_vertices = 0;
};

/// Reads a triangle mesh; the format follows from the file name's ending (.off .obj .ply .stl, any
/// case) and, for its variants, from the content. Vertices keep the file's order and number; only
/// STL, which has no vertices of its own, gets one for each distinct position in order of first
/// appearance. Throws `BadFile` for a missing, empty, truncated or malformed file, an index out of
/// range, coordinates that are not finite, or no faces. Never allocates more than a small multiple
/// of the file's size. O(N).
Mesh read_mesh(const std::string& path, MeshReadReport* report = nullptr);

/// Writes `mesh` as .off, .obj or .ply (binary little endian, float coordinates as doubles) by the
/// ending of `path`. The file appears whole or not at all. Coordinates survive a round trip
/// exactly. Throws `BadFile` if it cannot be written or the ending is unknown.
void write_mesh(const std::string& path, const Mesh& mesh);

}  // namespace isomatch
