// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>

#include "results/page/page_data.h"

namespace isomatch::cli {

/// Adds the flags that set `options`, in the option group `group` if it is not empty.
void add_page_options(CLI::App& command, results::PageOptions& options,
                      const std::string& group = "");

}  // namespace isomatch::cli
