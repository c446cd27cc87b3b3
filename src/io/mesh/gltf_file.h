// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <tiny_gltf.h>

#include "io/input_file.h"

namespace isomatch::mesh_io {

/// The content of a .glb or .gltf file with its buffers: the one inside of a .glb, data URIs, and
/// files beside it. Images are not looked at. Throws `BadFile` if it is malformed, not of version
/// 2, or needs an extension that changes what the numbers mean, which is told first.
tinygltf::Model load_gltf(const InputFile& file);

}  // namespace isomatch::mesh_io
