// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "synth/body.h"
#include "synth/pose.h"

namespace isomatch::synth {

/// True if parts that are apart at rest touch in the pose or almost do. Judged by balls along the
/// tubes.
bool collides(const Body& body, const Pose& pose);

}  // namespace isomatch::synth
