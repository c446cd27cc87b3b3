// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <chrono>
#include <string_view>

namespace isomatch::cli {

/// One line on standard error that shows how far the work has come; removed by the destructor.
/// Prints nothing if standard error is not a terminal or `quiet` is set.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows `fraction` in [0, 1] and the name of the stage; redraws at most ten times a second.
  void update(double fraction, std::string_view stage);

  /// Makes room for other text on standard error, if it is a terminal; the next update draws the
  /// bar again.
  static void clear_line();

 private:
  bool visible_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point next_draw_;
};

}  // namespace isomatch::cli
