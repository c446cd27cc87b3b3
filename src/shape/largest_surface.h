// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/mesh/surface.h"
#include "shape/sound_mesh.h"

namespace isomatch {

/// The second half of `extract_surface`: joins seams and picks the largest component. `sound` has
/// at least one face.
Surface largest_surface(SoundMesh sound);

}  // namespace isomatch
