// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace isomatch::cli {

/// What is wrong with the command line `words`, the program's name first, that `app` could not
/// parse: one line, with what may have been meant, and the help to look at.
std::string usage_error(const CLI::App& app, const std::vector<std::string>& words,
                        const CLI::ParseError& error);

/// `words` with `help` as a command turned into `--help`: of the command of `app` that follows, or
/// of the program. A word that follows and is no command stays alone.
std::vector<std::string> with_help_as_option(const CLI::App& app, std::vector<std::string> words);

}  // namespace isomatch::cli
