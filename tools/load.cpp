// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "load.h"

#include <utility>

#include "isomatch/error.h"
#include "isomatch/mesh_io.h"

namespace isomatch::cli {

Inspection inspected(const std::string& path, const Mesh& mesh) {
  try {
    Inspection inspection = inspect(mesh);
    if (!inspection.surface) throw InvalidInput("the mesh has no face of positive area");
    return inspection;
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

Shape prepare_loaded(const std::string& path, const Mesh& mesh, const Context& context) {
  try {
    return prepare_shape(mesh, {}, context);
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

Shape load_shape(const std::string& path, const Context& context) {
  return prepare_loaded(path, read_mesh(path), context);
}

}  // namespace isomatch::cli
