// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/unfinished.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <string_view>

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kUnfinishedEnding = ".unfinished";

std::string host() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// What such names end with, before the number of the process.
std::string mark_of_host() { return fmt::format(".{}-", host()); }

bool is_left_over(std::string_view name) {
  const std::string mark = mark_of_host();
  const auto at = name.rfind(mark);
  if (!name.starts_with('.') || !name.ends_with(kUnfinishedEnding) || at == std::string_view::npos)
    return false;
  const std::string_view number =
      name.substr(at + mark.size(), name.size() - at - mark.size() - kUnfinishedEnding.size());
  int process = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), process);
  return error == std::errc() && end == number.data() + number.size() && process != getpid() &&
         kill(process, 0) != 0 && errno == ESRCH;
}

}  // namespace

std::string unfinished_name(const std::string& pair) {
  return fmt::format(".{}{}{}{}", pair, mark_of_host(), getpid(), kUnfinishedEnding);
}

void remove_left_over(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    if (is_left_over(entry->path().filename().string())) fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace isomatch::results
