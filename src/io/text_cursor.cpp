// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace isomatch {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
/// Characters of a mantissa that is surely within the range of double.
constexpr std::size_t kShortMantissa = std::numeric_limits<double>::max_exponent10;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// std::from_chars knows no plus sign.
const char* skip_plus(const char* first, const char* last) {
  const bool plus = last - first > 1 && first[0] == '+' && first[1] != '-';
  return plus ? first + 1 : first;
}

/// Of a number out of the range of double: whether it is too small. Against a negative exponent, so
/// short a mantissa cannot make it too large.
bool is_tiny(std::string_view number) {
  const std::size_t exponent = number.find_first_of("eE");
  return exponent < kShortMantissa && number[exponent + 1] == '-';
}

}  // namespace

TextCursor::TextCursor(const InputFile& file, TextDialect dialect)
    : file_(&file), dialect_(dialect), position_(file.begin()), end_(file.end()) {
  if (file.content().starts_with(kByteOrderMark)) position_ += kByteOrderMark.size();
}

bool TextCursor::find_content() {
  while (at_line_end()) {
    if (position_ == end_) return false;
    skip_line();
  }
  return true;
}

bool TextCursor::at_line_end() {
  skip_blanks();
  return position_ == end_ || is_line_end(*position_) || (dialect_.comments && *position_ == '#');
}

void TextCursor::skip_line() {
  bool in_comment = false;
  while (position_ != end_ && !is_line_end(*position_)) {
    in_comment |= dialect_.comments && *position_ == '#';
    if (!in_comment && at_continuation(position_))
      skip_blanks();
    else
      ++position_;
  }
  if (position_ == end_) return;
  const bool two = position_[0] == '\r' && position_ + 1 != end_ && position_[1] == '\n';
  position_ += two ? 2 : 1;
}

void TextCursor::expect_line_end() {
  if (at_line_end()) return;
  const std::string_view found = at_separator(position_) ? std::string_view(position_, 1) : word();
  fail(fmt::format("expected the end of the line, found {}", in_quotes(found)));
}

void TextCursor::skip_separator() {
  skip_blanks();
  if (!at_separator(position_)) return;
  if (separator_ != 0 && *position_ != separator_)
    fail(fmt::format("columns are separated by '{}' before, and by '{}' here", separator_,
                     *position_));
  separator_ = *position_++;
}

std::string_view TextCursor::word() {
  const std::string_view result = peek_word();
  position_ += result.size();
  return result;
}

std::string_view TextCursor::peek_word() {
  if (at_line_end()) return {};
  return {position_, word_end()};
}

std::string TextCursor::rest_of_line() {
  std::string result;
  skip_blanks();
  while (position_ != end_ && !is_line_end(*position_)) {
    if (at_continuation(position_)) {
      skip_blanks();
      result += ' ';
    } else {
      result += *position_++;
    }
  }
  while (!result.empty() && is_blank(result.back())) result.pop_back();
  return result;
}

double TextCursor::coordinate() { return parse_number("a number"); }

double TextCursor::number() {
  skip_blanks();
  const char* const start = position_;
  const double value = parse_number("a number");
  if (std::isfinite(value)) return value;
  position_ = start;
  fail_number("a finite number");
}

double TextCursor::whole_number() {
  skip_blanks();
  const char* const start = position_;
  const double value = parse_number("an integer");
  if (std::isfinite(value) && value == std::floor(value)) return value;
  position_ = start;
  fail_number("an integer");
}

double TextCursor::parse_number(std::string_view expected) {
  skip_blanks();
  double value = 0;
  const auto [last, error] = std::from_chars(skip_plus(position_, end_), end_, value);
  if (error == std::errc::invalid_argument || !ends_word(last)) fail_number(expected);
  if (error == std::errc::result_out_of_range) {
    if (!is_tiny({position_, last})) fail_number("a number that fits a double");
    value = 0;
  }
  position_ = last;
  return value;
}

std::int64_t TextCursor::integer() {
  const auto [value, last] = parse_integer();
  if (!ends_word(last)) fail_number("an integer");
  position_ = last;
  return value;
}

std::int64_t TextCursor::leading_integer(char separator) {
  const auto [value, last] = parse_integer();
  if (!ends_word(last) && *last != separator) fail_number("an integer");
  position_ = word_end();
  return value;
}

TextCursor::ParsedInteger TextCursor::parse_integer() {
  skip_blanks();
  std::int64_t value = 0;
  const auto [last, error] = std::from_chars(skip_plus(position_, end_), end_, value);
  if (error == std::errc::invalid_argument) fail_number("an integer");
  if (error == std::errc::result_out_of_range) fail_number("an integer of at most 64 bits");
  return {value, last};
}

void TextCursor::skip_blanks() {
  while (position_ != end_) {
    if (is_blank(*position_)) {
      ++position_;
    } else if (at_continuation(position_)) {
      position_ += position_[1] == '\r' && position_ + 2 != end_ && position_[2] == '\n' ? 3 : 2;
    } else {
      return;
    }
  }
}

bool TextCursor::at_continuation(const char* at) const {
  return dialect_.continuations && end_ - at > 1 && at[0] == '\\' && is_line_end(at[1]);
}

bool TextCursor::ends_word(const char* at) const {
  return at == end_ || is_blank(*at) || is_line_end(*at) || (dialect_.comments && *at == '#') ||
         at_continuation(at) || at_separator(at);
}

bool TextCursor::at_separator(const char* at) const {
  return dialect_.separators && at != end_ && (*at == ',' || *at == ';');
}

const char* TextCursor::word_end() const {
  const char* at = position_;
  while (!ends_word(at)) ++at;
  return at;
}

void TextCursor::fail_number(std::string_view expected) const {
  const std::string_view found(position_, word_end());
  if (at_separator(position_)) fail(fmt::format("expected {}, but the column is empty", expected));
  if (found.empty()) fail(fmt::format("expected {}, but the line ends", expected));
  fail(fmt::format("expected {}, found {}", expected, in_quotes(found)));
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace isomatch
