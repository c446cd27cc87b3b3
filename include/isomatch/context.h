// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace isomatch {

/// Number of hardware threads, at least 1.
int hardware_threads();

/// How a computation runs, as opposed to what it computes: no field of this struct changes a
/// result.
struct Context {
  /// Threads to use, at least 1.
  int threads = hardware_threads();
  /// Called from the calling thread as work proceeds: fraction of the whole in [0, 1] and the name
  /// of the stage under way. May be empty.
  std::function<void(double fraction, std::string_view stage)> progress;
  /// Request a stop on its source to make the computation throw `Cancelled` soon.
  std::stop_token stop;

  /// Reports progress to `progress` if set. Throws `Cancelled` if a stop was requested.
  void report(double fraction, std::string_view stage) const;
  /// Throws `Cancelled` if a stop was requested.
  void check_stop() const;
};

}  // namespace isomatch
