// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "input_file.h"
#include "isomatch/atomic_file.h"
#include "isomatch/mesh.h"
#include "isomatch/mesh_io.h"

/// One reader and one writer a format; see `read_mesh` and `write_mesh` for what they promise.
namespace isomatch::mesh_io {

struct ReadResult {
  Mesh mesh;
  MeshReadReport report;
};

ReadResult read_off(const InputFile& file);
ReadResult read_obj(const InputFile& file);
ReadResult read_ply(const InputFile& file);
ReadResult read_stl(const InputFile& file);

void write_off(const Mesh& mesh, AtomicFile& file);
void write_obj(const Mesh& mesh, AtomicFile& file);
void write_ply(const Mesh& mesh, AtomicFile& file);

}  // namespace isomatch::mesh_io
