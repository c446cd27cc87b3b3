// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <functional>
#include <stop_token>
#include <string>

namespace isomatch::baselines {

/// How a child process ended.
struct ChildOutcome {
  /// Killed by this signal; 0 if it came to its end.
  int signal = 0;
  /// What `work` returned.
  std::string output;
};

/// Runs `work`, which must not throw, in a child process, whose memory is its own and whose crash
/// harms no one. The calling process must not have used OpenMP before, because the child could not
/// use it then. A stop request kills the child and throws `Cancelled`. Throws `InternalError` if
/// the system has no process to give.
ChildOutcome run_child(const std::function<std::string()>& work, const std::stop_token& stop);

}  // namespace isomatch::baselines
