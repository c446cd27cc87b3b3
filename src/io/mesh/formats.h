// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "io/input_file.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/io/model_io.h"
#include "isomatch/mesh/mesh.h"

/// One reader and one writer a format; see `read_mesh` and `write_mesh` for what they promise.
namespace isomatch::mesh_io {

/// The triangles that a polygon of more than three corners became: a fan around its first corner.
struct Fan {
  std::size_t first_face, faces;
};

struct ReadResult {
  Mesh mesh;
  MeshReadReport report;
  /// What only the readers that are asked for it fill, and only if the file has it.
  Texture texture;
  VertexColors colors;
  std::vector<Pose> poses;
  /// In the order of their faces.
  std::vector<Fan> fans;
  /// Of fewer than three corners, which are left out.
  int short_faces = 0;
};

/// What is left to do when all of a mesh has been read: throws `BadFile` unless there are vertices
/// and faces, and not too many; cuts polygons; warns of faces that were left out.
void complete(ReadResult& result, const InputFile& file);

/// A reader of a format whose files have one mesh, where none can be chosen.
template <ReadResult (*read)(const InputFile&)>
ReadResult read_only_mesh(const InputFile& file, const MeshReadOptions& options) {
  if (options.mesh) file.fail("only of a glTF file a mesh can be chosen by its name");
  return read(file);
}

ReadResult read_off(const InputFile& file);
ReadResult read_obj(const InputFile& file);
ReadResult read_ply(const InputFile& file);
ReadResult read_stl(const InputFile& file);
ReadResult read_gltf(const InputFile& file, const MeshReadOptions& options);
ReadResult read_mat(const InputFile& file);

ReadResult read_textured_obj(const InputFile& file);
ReadResult read_colored_ply(const InputFile& file);
ReadResult read_gltf_model(const InputFile& file, const MeshReadOptions& options);

void write_off(const Mesh& mesh, AtomicFile& file);
void write_obj(const Mesh& mesh, AtomicFile& file);
void write_ply(const Mesh& mesh, AtomicFile& file);
void write_glb(const Mesh& mesh, AtomicFile& file);
void write_gltf(const Mesh& mesh, AtomicFile& file);
void write_mat(const Mesh& mesh, AtomicFile& file);

void write_textured_obj(const Model& model, const std::vector<std::string>& libraries,
                        AtomicFile& file);
void write_colored_ply(const Mesh& mesh, const VertexColors& colors, AtomicFile& file);
void write_glb_model(const Model& model, AtomicFile& file);
void write_gltf_model(const Model& model, AtomicFile& file);

}  // namespace isomatch::mesh_io
