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
  /// Set by the chosen subcommand. Throws on failure; see `run_guarded` for what becomes of that.
  std::function<void(const Context&)> action;
  /// The words it consists of, the program's name first.
  std::vector<std::string> words;
  int threads = hardware_threads();
  bool quiet = false;
};

/// Each adds one subcommand: its options, an example as footer, and a callback that sets
/// `request.action`. A new subcommand is a file with such a function, a line here, and a line in
/// main.cpp. `request` must outlive `app`.
void add_match(CLI::App& app, Request& request);
void add_info(CLI::App& app, Request& request);
void add_eval(CLI::App& app, Request& request);
void add_synth(CLI::App& app, Request& request);
void add_render(CLI::App& app, Request& request);
void add_report(CLI::App& app, Request& request);
void add_transfer(CLI::App& app, Request& request);
void add_convert(CLI::App& app, Request& request);

/// Adds `--quiet`.
void add_quiet_option(CLI::App& command, Request& request);
/// Adds `--threads` and `--quiet`, for subcommands that take more than a moment.
void add_run_options(CLI::App& command, Request& request);

/// Sets the end of `command`'s help: `example`, one or more complete command lines, and the page of
/// docs that has more.
void set_example(CLI::App& command, const std::string& example, const std::string& page);

}  // namespace isomatch::cli
