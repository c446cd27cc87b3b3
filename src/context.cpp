// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/context.h"

#include <algorithm>
#include <thread>

#include "isomatch/error.h"

namespace isomatch {

int hardware_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void Context::report(double fraction, std::string_view stage) const {
  check_stop();
  if (progress) progress(fraction, stage);
}

void Context::check_stop() const {
  if (stop.stop_requested()) throw Cancelled();
}

}  // namespace isomatch
