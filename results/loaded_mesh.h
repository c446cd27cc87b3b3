// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "isomatch/shape/diagnosis.h"
#include "isomatch/shape/shape.h"

/// Stages on a mesh that was read from the file `path`, which is to blame: what makes the mesh
/// unusable is a `BadFile`.
namespace isomatch::results {

/// `diagnose`.
MeshDiagnosis diagnosed(const std::string& path, const Mesh& mesh);

/// The shape of a mesh that was read from `path`. What makes it unusable is a `BadFile`.
Shape shape_of(const std::string& path, Mesh mesh, const GeodesicOptions& geodesics = {});

}  // namespace isomatch::results
