// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "load.h"

#include "isomatch/error.h"
#include "isomatch/mesh_io.h"

namespace isomatch::cli {

Shape load_shape(const std::string& path, const Context& context) {
  const Mesh mesh = read_mesh(path);
  try {
    return prepare_shape(mesh, {}, context);
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

}  // namespace isomatch::cli
