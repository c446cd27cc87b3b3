// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "random.h"
#include "synth/body.h"

namespace isomatch::synth {

/// A four- or six-legged animal with a neck, a head with ears, and a tail. Front and hind legs
/// differ by at least a tenth in length, head and tail always. The trunk is of length 1, hip at z =
/// 0.
Body make_creature(Random& random);

}  // namespace isomatch::synth
