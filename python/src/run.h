// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>

#include "isomatch/context.h"

namespace isomatch::python {

/// How the caller wants long work to run.
struct RunOptions {
  /// Number of threads, or None for as many as the machine has.
  pybind11::object threads;
  /// Called with fraction and stage, or None.
  pybind11::object progress;
};

/// Runs `work` without the interpreter's lock, so that other Python threads go on. Ctrl-C, or an
/// exception in the progress callback, stops it and is raised here; the callback is called in the
/// calling thread. Throws what `work` throws. `work` must not touch Python objects.
void run_work(const RunOptions& options, const std::function<void(const Context&)>& work);

/// The same for work with a result.
template <class Work>
auto run(const RunOptions& options, const Work& work) {
  std::optional<decltype(work(Context{}))> result;
  run_work(options, [&](const Context& context) { result.emplace(work(context)); });
  return std::move(*result);
}

}  // namespace isomatch::python
