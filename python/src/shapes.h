// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>

#include "results/folder/inputs.h"

namespace isomatch::python {

/// What Python users know as a shape: where a mesh came from, what reading it told, and what is
/// prepared of it.
using results::MatchInput;

inline results::MatchInputs to_inputs(const MatchInput& source, const MatchInput& target) {
  return {{}, std::filesystem::current_path().string(), source, target, {}};
}

}  // namespace isomatch::python
