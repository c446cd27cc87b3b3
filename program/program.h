// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>

#include "program/request.h"

namespace isomatch::cli {

/// Lets idle threads sleep instead of spin, unless the user decided otherwise. Where other programs
/// keep the cores busy, spinning made a match four to ten times slower; where they do not, it gains
/// nothing measurable. OpenMP reads the setting when it is loaded, before `main`, so the program
/// starts itself once more: call this first.
void restart_without_spinning(char** argv);

/// Parses the command line, keeps its words in `request`, runs `request`'s action and turns what it
/// throws into one line on standard error, beginning with the name of `app`, and an exit code: 0 on
/// success, 2 for bad input, 3 if some of many things failed, 130 when interrupted, 1 for anything
/// else.
int run_program(CLI::App& app, Request& request, int argc, char** argv);

}  // namespace isomatch::cli
