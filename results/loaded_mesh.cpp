// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/loaded_mesh.h"

#include <utility>

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

Shape shape_of(const std::string& path, Mesh mesh, const GeodesicOptions& geodesics) {
  return of_file(path, [&] { return Shape(std::move(mesh), geodesics); });
}

}  // namespace isomatch::results
