// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "isomatch/diagnosis.h"
#include "isomatch/shape.h"

namespace isomatch::cli {

/// Diagnosis and surface, of which there is one, of a mesh that was read from `path`. What makes it
/// unusable is a `BadFile`.
Inspection inspected(const std::string& path, const Mesh& mesh);

/// `prepare_shape` of a mesh that was read from `path`. What makes it unusable is a `BadFile`.
Shape prepare_loaded(const std::string& path, const Mesh& mesh, const Context& context);

/// Reads a mesh and prepares it. What makes it unusable is a `BadFile` that names `path`.
Shape load_shape(const std::string& path, const Context& context);

}  // namespace isomatch::cli
