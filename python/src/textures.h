// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/pybind11.h>

#include "isomatch/mesh/texture.h"

namespace isomatch::python {

/// A tuple of vertices, faces, texture coordinates, corners, names of materials and the material of
/// each face. Throws `InvalidInput` if they do not fit together.
TexturedMesh to_textured(const pybind11::tuple& parts);
/// The same by name.
pybind11::dict to_dict(TexturedMesh textured);

}  // namespace isomatch::python
