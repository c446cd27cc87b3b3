// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch {

/// What a reader had to do to make an indexed triangle mesh of a file.
struct MeshReadReport {
  /// Polygons of more than three corners, each cut into a fan of triangles around its first corner.
  int triangulated_polygons = 0;
  /// STL only: corners of triangles that share a vertex with an earlier corner, because their
  /// positions are exactly equal (-0 equals 0).
  int merged_vertices = 0;
  /// What was left out or had to be guessed, a sentence each without the file's name; what happens
  /// often is told once, with its number.
  std::vector<std::string> warnings;
  /// glTF only: the names of the meshes that were read as one, those of their nodes if these have
  /// any.
  std::vector<std::string> meshes;
};

struct MeshReadOptions {
  /// glTF only: the name of a mesh, or of its node, to read instead of all that the scene shows.
  std::optional<std::string> mesh;
};

/// Reads a triangle mesh and reports to `report`, unless it is null. The file name's ending tells
/// the format, in upper or lower case:
/// - .off: OFF and its variants with colours, normals and texture coordinates (COFF, NOFF, STOFF
/// and
///   their combinations), which are passed over; ASCII, one vertex or face a line; # comments.
/// - .obj: `v` and `f` lines; everything else in it is passed over.
/// - .ply: ASCII and binary of both byte orders, any properties; elements "vertex", "face" and
///   "tristrips", others are passed over.
/// - .stl: ASCII and binary, whichever the content is.
/// - .glb, .gltf: glTF 2.0, its buffers inside, in data URIs or in files beside it. All meshes of
///   the scene that is shown, depth first, as one mesh: their triangles, strips and fans, moved by
///   the transforms of the nodes above them. A mesh that several nodes show is read as often.
///   Parts of a mesh that share their positions share vertices. Without a scene, all meshes as
///   they are; skinned ones stay in their bind pose. Lines, points and meshes that are not in the
///   scene are warned of. Not read: files compressed by Draco or by meshopt.
/// - .mat: the one shape in a MATLAB file of level 5: matrices X, Y, Z or VERT, and TRIV, as in
///   TOSCA, or vertices and faces, as fields of a struct, within others or not, or by themselves.
///   TRIV and faces count vertices from one. Files of several shapes are refused.
///
/// Vertices keep the file's order and number. Only STL has no vertices of its own: it gets one for
/// each distinct position, in order of first appearance. Faces keep the file's order too.
///
/// Throws `BadFile` for a file without the mesh that `options` name, and for one that is missing,
/// empty, truncated, malformed, or longer than it announces (.ply: a warning), for an index out of
/// range, and for a mesh without vertices or faces. The message names the line in text formats and
/// the byte, from 0, in binary ones. What is returned passes `validate`; coordinates may be
/// infinite or not a number; `MeshDiagnosis` counts these.
///
/// O(N). Numbers do not depend on the locale. Memory stays within a small multiple of the file's
/// size (of what it unpacks to, where it is compressed), whatever the file announces.
Mesh read_mesh(const std::string& path, MeshReadReport* report = nullptr,
               const MeshReadOptions& options = {});

/// Writes `mesh` as .off, .obj, .ply (binary little endian, double coordinates), .glb, .gltf (in
/// one file) or .mat (a struct `surface` of X, Y, Z and TRIV) by the ending of `path`. The file
/// appears whole or not at all, see `AtomicFile`. Vertex order and faces survive a round trip
/// exactly, and so do coordinates, which glTF rounds to 32 bits. Throws `InvalidInput` if `mesh`
/// fails `validate`, `BadFile` if the file cannot be written, the ending is another one, or the
/// mesh is too large for the format. O(N).
void write_mesh(const std::string& path, const Mesh& mesh);

/// Throws the `BadFile` that `write_mesh` would throw because of `path` alone, for use before long
/// work. Leaves no trace.
void check_mesh_output(const std::string& path);

/// Whether `path` ends like a mesh file that `read_mesh` knows.
bool is_mesh_file_name(const std::string& path);

}  // namespace isomatch
