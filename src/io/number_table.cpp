// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/number_table.h"

#include <string_view>

namespace isomatch {
namespace {

bool begins_like_a_number(std::string_view word) {
  return word.find_first_of("0123456789+-.") == 0 || equal_ignoring_case(word, "nan");
}

bool has_names_only(TextCursor line) {
  for (; !line.at_line_end(); line.skip_separator())
    if (begins_like_a_number(line.word())) return false;
  return true;
}

}  // namespace

TextCursor table_rows(const InputFile& file) {
  TextCursor cursor(file, kNumberTable);
  if (cursor.find_content() && has_names_only(cursor)) cursor.skip_line();
  return cursor;
}

}  // namespace isomatch
