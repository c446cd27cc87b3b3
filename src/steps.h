// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <atomic>
#include <string_view>
#include <thread>

#include "isomatch/context.h"

namespace isomatch {

/// `context` for a part of its work, from the fraction `begin` to `end` of it. Keeps a reference.
inline Context part_of(const Context& context, double begin, double end) {
  Context part = context;
  if (context.progress)
    part.progress = [&context, begin, end](double fraction, std::string_view stage) {
      context.progress(begin + (end - begin) * fraction, stage);
    };
  return part;
}

/// The progress of a stage, or a part of one, of steps that several threads take. It is reported
/// from the thread that made the object, as a context's progress has to be, when that thread has
/// taken a step.
class Steps {
 public:
  /// From the fraction `begin` to `end` of the whole. Keeps a reference to `context`.
  Steps(const Context& context, std::string_view stage, double begin, double end, int count)
      : context_(context), stage_(stage), begin_(begin), end_(end), count_(count) {}

  /// Another step is done. For any thread; throws `Cancelled` after a stop.
  void take() {
    const int done = ++done_;
    if (std::this_thread::get_id() == owner_)
      context_.report(begin_ + (end_ - begin_) * done / count_, stage_);
  }

 private:
  const Context& context_;
  std::string_view stage_;
  double begin_, end_;
  int count_;
  std::atomic<int> done_ = 0;
  std::thread::id owner_ = std::this_thread::get_id();
};

}  // namespace isomatch
