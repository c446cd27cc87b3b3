// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "isomatch/context.h"

namespace isomatch::cli {

/// What the command line asked for.
struct Request {
  /// Set by the program or its chosen subcommand. Throws on failure; see `run_program` for what
  /// becomes of that.
  std::function<void(const Context&)> action;
  /// The words it consists of, the program's name first.
  std::vector<std::string> words;
  int threads = hardware_threads();
  bool quiet = false;
};

/// Adds `--quiet`.
void add_quiet_option(CLI::App& command, Request& request);
/// Adds `--threads` and `--quiet`, for commands that take more than a moment.
void add_run_options(CLI::App& command, Request& request);

/// Sets the end of `command`'s help: `example`, one or more complete command lines, and the page of
/// docs that has more.
void set_example(CLI::App& command, const std::string& example, const std::string& page);

}  // namespace isomatch::cli
