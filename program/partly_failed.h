// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <stdexcept>

namespace isomatch::cli {

/// Of many things that a command was to do, some could not be done; the others are.
class PartlyFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace isomatch::cli
