// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program/closest_word.h"

#include <algorithm>
#include <utility>

namespace isomatch::cli {
namespace {

/// How many letters differ (Damerau's distance, of which no letter is part twice).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1,
                                              std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = 0; i <= a.size(); ++i) table[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) table[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      table[i][j] = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
    }
  }
  return table[a.size()][b.size()];
}

}  // namespace

std::optional<std::string> closest_word(std::string_view word,
                                        const std::vector<std::string>& known) {
  constexpr std::size_t kLettersAMistake = 3, kShortestBeginning = 3;
  std::optional<std::string> closest;
  std::size_t least = word.size() / kLettersAMistake + 1;
  for (const std::string& candidate : known) {
    const bool is_beginning = word.size() >= kShortestBeginning && candidate.starts_with(word);
    const std::size_t mistakes = is_beginning ? 0 : distance(word, candidate);
    if (mistakes >= least) continue;
    least = mistakes;
    closest = candidate;
  }
  return closest;
}

}  // namespace isomatch::cli
