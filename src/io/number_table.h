// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "io/text_cursor.h"

namespace isomatch {

/// Tables of numbers as people and spreadsheets write them: columns are separated by blanks, tabs,
/// commas or semicolons, comments follow behind #. After a column call `skip_separator`.
inline constexpr TextDialect kNumberTable{.comments = true, .separators = true};

/// A cursor at the beginning of a table, behind the names of its columns if the first line has
/// such: that is one in which no word begins like a number.
TextCursor table_rows(const InputFile& file);

}  // namespace isomatch
