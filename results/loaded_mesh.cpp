// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/loaded_mesh.h"

#include "isomatch/error.h"

namespace isomatch::results {
namespace {

template <class Work>
auto of_file(const std::string& path, const Work& work) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    throw BadFile(path, error.what());
  }
}

}  // namespace

MeshDiagnosis diagnosed(const std::string& path, const Mesh& mesh) {
  return of_file(path, [&] { return diagnose(mesh); });
}

Inspection inspected(const std::string& path, const Mesh& mesh) {
  return of_file(path, [&] {
    Inspection inspection = inspect(mesh);
    if (!inspection.surface) throw InvalidInput("the mesh has no face of positive area");
    return inspection;
  });
}

Shape prepare_loaded(const std::string& path, const Mesh& mesh, const Context& context) {
  return of_file(path, [&] { return prepare_shape(mesh, {}, context); });
}

}  // namespace isomatch::results
