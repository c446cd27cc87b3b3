// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/io/model_io.h"
#include "results/folder/result.h"

namespace isomatch::results {

/// The source of a result for other programs: in the colours of the points that it is matched to,
/// as `isomatch render` draws it, with the texture coordinates of its file, if there are any, and
/// with its other pose, `registered`, if the method has one. Reads the source's file again.
Model result_model(const MatchResult& result, const ResultMap& map);

}  // namespace isomatch::results
