// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "results/picture/image.h"

namespace isomatch::picture {

/// The colour of a share of a scale, from dark violet at 0 to light yellow at 1: even steps look
/// even, also without red and green. Shares are clamped to [0, 1].
Color viridis(double share);

}  // namespace isomatch::picture
