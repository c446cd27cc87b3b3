// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "group/alignment.h"

namespace isomatch {

/// Gives shapes the points that they lack: those that are likeliest after the points that they
/// have, if shapes are distributed normally as the other shapes are. That changes the alignment and
/// the distribution, so it is repeated until nothing changes.
void complete_shapes(const CorrespondingPoints& shapes, bool keep_size, AlignedShapes& aligned);

}  // namespace isomatch
