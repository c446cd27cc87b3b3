// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/input_file.h"

namespace isomatch {

/// What a text format allows besides words and line ends.
struct TextDialect {
  /// A # starts a comment that lasts to the end of the line.
  bool comments = false;
  /// A backslash at the end of a line joins it with the next one.
  bool continuations = false;
  /// A comma or a semicolon ends a word, see `TextCursor::skip_separator`.
  bool separators = false;
};

/// Walks through a text file, word by word and line by line, from its beginning (behind a byte
/// order mark, if there is one). Words are separated by blanks; lines end with \n, \r\n or \r.
/// Everything is read independently of the locale; failures are `BadFile` and name the line. Linear
/// time.
class TextCursor {
 public:
  /// Keeps a reference to `file`.
  explicit TextCursor(const InputFile& file, TextDialect dialect = {});

  /// Moves on to the next word on this or a later line; false at the end of the file. Blank lines
  /// and comments are passed over.
  bool find_content();
  /// True if nothing but blanks and a comment is left on this line.
  bool at_line_end();
  /// Moves to the start of the next line, whatever is left on this one.
  void skip_line();
  /// Fails unless `at_line_end`.
  void expect_line_end();

  /// Moves behind a comma or semicolon, if one is next; so an empty column is none. Of a file's
  /// separators all must be the same: 1,5;2,5 would be two numbers to its author.
  void skip_separator();

  /// The next word on this line, empty at its end. `peek_word` stays in front of it.
  std::string_view word();
  std::string_view peek_word();
  /// The rest of this line without the blanks around it; a # is part of it. A joined line follows
  /// after a blank.
  std::string rest_of_line();
  /// The next word as a number, "nan" and "inf" among them; one that is too small for a double is
  /// zero.
  double coordinate();
  /// The same, which must be finite.
  double number();
  /// The same, which must be whole; 2.0 and 2e0 are.
  double whole_number();
  /// The next word as an integer.
  std::int64_t integer();
  /// The integer at the beginning of the next word, which ends there or goes on with `separator`.
  /// Moves behind the word.
  std::int64_t leading_integer(char separator);

  const char* position() const { return position_; }
  void set_position(const char* position) { position_ = position; }
  /// Bytes from here to the end of the file.
  std::int64_t remaining() const { return end_ - position_; }
  [[noreturn]] void fail(const std::string& reason) const {
    file_->fail_at_line(position_, reason);
  }

 private:
  struct ParsedInteger {
    std::int64_t value;
    /// Where the digits end.
    const char* last;
  };

  double parse_number(std::string_view expected);
  ParsedInteger parse_integer();
  void skip_blanks();
  bool at_continuation(const char* at) const;
  bool ends_word(const char* at) const;
  bool at_separator(const char* at) const;
  const char* word_end() const;
  [[noreturn]] void fail_number(std::string_view expected) const;

  const InputFile* file_;
  TextDialect dialect_;
  const char* position_;
  const char* end_;
  /// The one that the file uses, 0 as long as that is not known.
  char separator_ = 0;
};

/// Whether `a` and `b` differ at most in the case of the letters A to Z.
bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace isomatch
