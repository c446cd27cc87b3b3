// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace isomatch::cli {
namespace {

constexpr int kBarWidth = 30;
constexpr std::string_view kClearLine = "\r\x1b[K";

void write_to_stderr(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) write_to_stderr(kClearLine);
}

void ProgressBar::update(double fraction, std::string_view stage) {
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || now < next_draw_) return;
  next_draw_ = now + std::chrono::milliseconds(100);
  drawn_ = true;
  const double share = std::clamp(fraction, 0.0, 1.0);
  const std::string filled(static_cast<std::size_t>(std::lround(share * kBarWidth)), '#');
  write_to_stderr(
      fmt::format("{}[{:<{}}] {:3.0f}% {}", kClearLine, filled, kBarWidth, share * 100, stage));
}

void ProgressBar::clear_line() {
  if (isatty(STDERR_FILENO) == 1) write_to_stderr(kClearLine);
}

}  // namespace isomatch::cli
