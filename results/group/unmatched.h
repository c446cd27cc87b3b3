// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "results/group/group_run.h"

namespace isomatch::results {

/// Moves shapes that could not be matched, or of which too little could for statistics, to those
/// that are left out, with all their pairs. Throws `InvalidInput` if fewer than two remain.
void leave_out_unmatched(GroupRun& run);

}  // namespace isomatch::results
