// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "isomatch/mesh/diagnosis.h"
#include "isomatch/mesh/shape.h"

/// Stages on a mesh that was read from the file `path`, which is to blame: what makes the mesh
/// unusable is a `BadFile`.
namespace isomatch::results {

/// `diagnose`.
MeshDiagnosis diagnosed(const std::string& path, const Mesh& mesh);

/// `inspect`; there is a surface.
Inspection inspected(const std::string& path, const Mesh& mesh);

/// `prepare_shape`.
Shape prepare_loaded(const std::string& path, const Mesh& mesh, const Context& context);

}  // namespace isomatch::results
