// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace isomatch::cli {

/// One line on standard error that shows how far the work has come, in which stage it is and how
/// long it may still take; removed by the destructor. Prints nothing if standard error is not a
/// terminal or `quiet` is set. There is one at a time.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows `fraction` in [0, 1] and the name of the stage: a new stage at once, otherwise the last
  /// of what it was told ten times a second.
  void update(double fraction, std::string_view stage);

  /// Makes room for other text on the terminal, if there is a bar; the next update draws it again.
  /// Call it before whatever a command prints.
  static void make_room();

 private:
  using Clock = std::chrono::steady_clock;

  /// What is to be shown.
  struct State {
    double fraction = 0;
    std::string stage;
    Clock::time_point since;
  };

  void redraw_from_time_to_time(const std::stop_token& closing);
  void draw();
  void clear();
  std::optional<double> seconds_left() const;

  static ProgressBar* current_;

  const bool visible_;
  /// When the work began that `fraction_` is of: it falls where another work follows.
  Clock::time_point begun_ = Clock::now();
  double fraction_ = 0;
  std::mutex mutex_;
  /// Nothing while there is room for other text.
  std::optional<State> state_;
  /// The line on the terminal, empty if there is none.
  std::string drawn_;
  std::condition_variable_any closing_;
  std::jthread drawer_;
};

}  // namespace isomatch::cli
