// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <chrono>
#include <csignal>
#include <optional>
#include <string>
#include <vector>

#include "programs.h"

namespace isomatch::test {

/// How a run of the program ended.
struct Outcome {
  int exit_code = 0;
  std::string output;
  std::string errors;
};

struct RunOptions {
  /// The file to run.
  std::string program = isomatch_program();
  /// Standard error is a terminal instead of a pipe.
  bool terminal = false;
  /// Standard output and standard error are the same terminal; all is in `Outcome::output`.
  bool all_on_terminal = false;
  /// Send a signal this long after the start.
  std::optional<std::chrono::milliseconds> interrupt_after = std::nullopt;
  int signal = SIGINT;
};

/// Runs `isomatch`, unless told otherwise, with `arguments` and empty standard input, and waits for
/// its end. A death by a signal counts as exit code 128 + signal.
Outcome run(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace isomatch::test
