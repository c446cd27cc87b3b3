// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace isomatch {

struct StageTime {
  std::string stage;
  /// Wall-clock time, summed over all its parts.
  double seconds = 0;
  /// The most resident memory that the process has had by the end of the stage, in MiB.
  double peak_memory_mib = 0;
};

/// Adds the time until its destruction to the entry of `stage` in `times`.
class StageTimer {
 public:
  StageTimer(std::vector<StageTime>& times, std::string_view stage)
      : times_(times), stage_(stage), start_(std::chrono::steady_clock::now()) {}
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;
  ~StageTimer();

 private:
  std::vector<StageTime>& times_;
  std::string_view stage_;
  std::chrono::steady_clock::time_point start_;
};

/// The most resident memory that this process has had so far.
double peak_memory_mib();

}  // namespace isomatch
