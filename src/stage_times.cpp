// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/stage_times.h"

#include <sys/resource.h>

#include <algorithm>

namespace isomatch {

StageTimer::~StageTimer() {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  auto entry = std::ranges::find(times_, stage_, &StageTime::stage);
  if (entry == times_.end()) entry = times_.insert(times_.end(), {std::string(stage_)});
  entry->seconds += elapsed.count();
  entry->peak_memory_mib = peak_memory_mib();
}

double peak_memory_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace isomatch
