// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>

#include "io/text_cursor.h"

namespace isomatch {

/// Files of numbers, a vertex a line, as numpy's `savetxt` writes them too: with a header in
/// comments.
inline constexpr TextDialect kNumberLines{.comments = true};

/// The next word as an integer, which may be written as a float: 12, 1.2e+01. Fails as
/// `TextCursor::integer`.
std::int64_t whole_number(TextCursor& cursor);

}  // namespace isomatch
