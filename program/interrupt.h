// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace isomatch::cli {

/// While alive, turns the first SIGINT or SIGTERM into a stop request and lets the second end the
/// process at once. Create it before any other thread, because it blocks both signals in the
/// calling thread, and threads started later inherit that.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  std::stop_token token() const { return stop_.get_token(); }
  /// The signal that requested the stop, 0 if none did.
  int signal() const { return signal_; }

 private:
  void wait_for_signals(const std::stop_token& closing);

  std::stop_source stop_;
  std::atomic<int> signal_ = 0;
  std::jthread watcher_;
};

}  // namespace isomatch::cli
