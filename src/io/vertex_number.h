// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "io/text_cursor.h"

namespace isomatch {

/// A number of a text file, and where it stands.
struct FileNumber {
  std::int64_t number;
  TextCursor cursor;
};

/// The next word as an integer, see `whole_number`.
FileNumber read_number(TextCursor& cursor);

/// One shape's vertices as a file numbers them.
struct VertexRange {
  std::string_view shape;
  /// Nothing if it is not known.
  std::optional<int> count;
  int first;
};

/// The 0-based vertex that `number` stands for; `kUnmatched` for one less than the first if
/// `may_be_unmatched`. Throws `BadFile` if it is not in `range`.
int checked_vertex(const FileNumber& number, const VertexRange& range,
                   bool may_be_unmatched = false);

}  // namespace isomatch
