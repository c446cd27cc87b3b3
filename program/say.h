// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "program/progress_bar.h"

namespace isomatch::cli {

/// Prints a line on standard output, for which the progress bar makes room.
template <class... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  ProgressBar::make_room();
  fmt::print("{}\n", fmt::format(format, std::forward<Arguments>(arguments)...));
}

}  // namespace isomatch::cli
