// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/whole_number.h"

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

namespace isomatch {
namespace {

/// The value of a word that is a float without a fraction; nothing where an integer, which loses no
/// digits, says as much.
std::optional<std::int64_t> written_as_float(std::string_view word) {
  constexpr double kExact = 1LL << 53;
  if (word.find_first_of(".eE") == std::string_view::npos) return std::nullopt;
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const char* const end = std::to_address(word.end());
  double value = 0;
  const auto [last, error] = std::from_chars(std::to_address(word.begin()), end, value);
  if (error != std::errc() || last != end) return std::nullopt;
  if (std::floor(value) != value || std::abs(value) > kExact) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

}  // namespace

std::int64_t whole_number(TextCursor& cursor) {
  const std::optional<std::int64_t> value = written_as_float(cursor.peek_word());
  if (!value) return cursor.integer();
  cursor.word();
  return *value;
}

}  // namespace isomatch
