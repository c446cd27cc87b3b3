// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "run.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "isomatch/error.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

/// How soon Ctrl-C is noticed.
constexpr std::chrono::milliseconds kPollInterval{20};

int thread_count(const py::object& threads) {
  if (threads.is_none()) return hardware_threads();
  const int count = threads.cast<int>();
  if (count < 1) throw InvalidInput("threads: expected at least 1");
  return count;
}

/// Python handles signals between its own instructions, in the thread that called us. Hence work
/// that runs in a thread of its own, while the calling thread looks for signals.
class Worker {
 public:
  Worker(int threads, const std::function<void(const Context&)>& work) {
    context_.threads = threads;
    context_.stop = stop_.get_token();
    context_.progress = [this](double fraction, std::string_view stage) {
      const std::lock_guard lock(mutex_);
      reports_.emplace_back(fraction, stage);
    };
    thread_ = std::thread([this, &work] { execute(work); });
  }
  ~Worker() {
    stop_.request_stop();
    if (thread_.joinable()) thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Whether the work ended within `kPollInterval`.
  bool wait() {
    std::unique_lock lock(mutex_);
    return finished_.wait_for(lock, kPollInterval, [this] { return done_; });
  }

  std::vector<std::pair<double, std::string>> take_reports() {
    const std::lock_guard lock(mutex_);
    return std::exchange(reports_, {});
  }

  /// Once the work ended: throws what it threw.
  void finish() {
    thread_.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void execute(const std::function<void(const Context&)>& work) {
    try {
      work(context_);
    } catch (...) {
      error_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    done_ = true;
    finished_.notify_one();
  }

  Context context_;
  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable finished_;
  std::vector<std::pair<double, std::string>> reports_;
  bool done_ = false;
  std::exception_ptr error_;
  std::thread thread_;
};

void pass_on(Worker& worker, const py::object& progress) {
  const auto reports = worker.take_reports();
  if (progress.is_none()) return;
  for (const auto& [fraction, stage] : reports) progress(fraction, stage);
}

}  // namespace

void run_work(const RunOptions& options, const std::function<void(const Context&)>& work) {
  const int threads = thread_count(options.threads);
  const py::gil_scoped_release release;
  Worker worker(threads, work);
  for (bool done = false; !done;) {
    done = worker.wait();
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    pass_on(worker, options.progress);
  }
  worker.finish();
}

}  // namespace isomatch::python
