// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/vertex_number.h"

#include <fmt/format.h>

#include <limits>

#include "io/whole_number.h"

namespace isomatch {

FileNumber read_number(TextCursor& cursor) {
  const TextCursor before = cursor;
  return {whole_number(cursor), before};
}

int checked_vertex(const FileNumber& number, const VertexRange& range, bool may_be_unmatched) {
  const auto& [shape, count, first] = range;
  const std::int64_t lowest = first - (may_be_unmatched ? 1 : 0);
  const std::int64_t end =
      std::int64_t{first} + count.value_or(std::numeric_limits<int>::max() - 1);
  if (number.number < lowest || number.number >= end)
    number.cursor.fail(
        count ? fmt::format("vertex {} is out of range: the {} has {} vertices, numbered from {}",
                            number.number, shape, *count, first)
              : fmt::format("{} is no vertex numbered from {}", number.number, first));
  return static_cast<int>(number.number - first);
}

}  // namespace isomatch
