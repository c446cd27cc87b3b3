// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "results/folder/result.h"

namespace isomatch::results {

/// Lets vertices that are not finite or stray, which would make everything else a dot, lie where
/// others are.
void make_drawable(Mesh& mesh);

/// The same of both meshes and of the poses of the source.
void make_drawable(MatchResult& result);

}  // namespace isomatch::results
