// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "load.h"

#include "isomatch/error.h"
#include "isomatch/mesh_io.h"

namespace isomatch::cli {

Shape prepare_loaded(const std::string& path, const Mesh& mesh, const GeodesicOptions& options,
                     const Context& context) {
  try {
    return prepare_shape(mesh, options, context);
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

Shape load_shape(const std::string& path, const Context& context) {
  return prepare_loaded(path, read_mesh(path), {}, context);
}

}  // namespace isomatch::cli
