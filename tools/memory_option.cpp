// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "memory_option.h"

#include <cmath>

namespace isomatch::cli {

void add_memory_option(CLI::App& command, double& gib, const std::string& description) {
  constexpr double kMostGiB = 1e6;
  command.add_option("--memory", gib, description)
      ->type_name("GIB")
      ->check(CLI::Range(0.0, kMostGiB))
      // No bound holds back what is no number.
      ->check([](const std::string& text) {
        double value = 0;
        const bool is_number = CLI::detail::lexical_cast(text, value) && !std::isnan(value);
        return is_number ? std::string() : text + " is not a number";
      })
      ->capture_default_str();
}

std::uint64_t bytes_of_gib(double gib) {
  constexpr double kGiB = 1 << 30;
  return static_cast<std::uint64_t>(gib * kGiB);
}

}  // namespace isomatch::cli
