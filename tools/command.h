// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>

#include "program/request.h"

namespace isomatch::cli {

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
void add_batch(CLI::App& app, Request& request);
void add_group(CLI::App& app, Request& request);

}  // namespace isomatch::cli
