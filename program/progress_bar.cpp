// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isomatch::cli {
namespace {

constexpr int kBarWidth = 30;
constexpr std::string_view kClearLine = "\r\x1b[K";
constexpr std::chrono::milliseconds kRedraw(100);

void write_to_stderr(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

std::string time_left(double seconds) {
  constexpr double kMinute = 60;
  if (seconds < 1) return "";
  if (seconds < 2 * kMinute) return fmt::format(", about {:.0f} s left", seconds);
  return fmt::format(", about {:.0f} min left", seconds / kMinute);
}

}  // namespace

ProgressBar* ProgressBar::current_ = nullptr;

ProgressBar::ProgressBar(bool quiet) : visible_(!quiet && isatty(STDERR_FILENO) == 1) {
  if (!visible_) return;
  current_ = this;
  drawer_ =
      std::jthread([this](const std::stop_token& closing) { redraw_from_time_to_time(closing); });
}

ProgressBar::~ProgressBar() {
  if (!visible_) return;
  make_room();
  current_ = nullptr;
}

void ProgressBar::update(double fraction, std::string_view stage) {
  if (!visible_) return;
  const std::scoped_lock lock(mutex_);
  if (fraction < fraction_) begun_ = Clock::now();
  fraction_ = fraction;
  const bool is_new = !state_ || state_->stage != stage;
  state_ = {std::clamp(fraction, 0.0, 1.0), std::string(stage), Clock::now()};
  if (is_new) draw();
}

void ProgressBar::make_room() {
  if (current_ == nullptr) return;
  const std::scoped_lock lock(current_->mutex_);
  current_->clear();
}

void ProgressBar::redraw_from_time_to_time(const std::stop_token& closing) {
  std::unique_lock lock(mutex_);
  while (!closing_.wait_for(lock, closing, kRedraw, [&] { return closing.stop_requested(); }))
    if (state_) draw();
}

/// From how far the work has come so far, which says little at its beginning.
std::optional<double> ProgressBar::seconds_left() const {
  constexpr double kLeastFraction = 0.15, kLeastSeconds = 1;
  const std::chrono::duration<double> worked = state_->since - begun_;
  if (state_->fraction < kLeastFraction || worked.count() < kLeastSeconds) return std::nullopt;
  const std::chrono::duration<double> since = Clock::now() - state_->since;
  return worked.count() * (1 - state_->fraction) / state_->fraction - since.count();
}

void ProgressBar::draw() {
  const double share = state_->fraction;
  const std::string filled(static_cast<std::size_t>(std::lround(share * kBarWidth)), '#');
  std::string line =
      fmt::format("[{:<{}}] {:3.0f}% {}{}", filled, kBarWidth, std::floor(share * 100),
                  state_->stage, time_left(seconds_left().value_or(0)));
  if (line == drawn_) return;
  write_to_stderr(fmt::format("{}{}", kClearLine, line));
  drawn_ = std::move(line);
}

void ProgressBar::clear() {
  if (!drawn_.empty()) write_to_stderr(kClearLine);
  drawn_.clear();
  state_.reset();
}

}  // namespace isomatch::cli
