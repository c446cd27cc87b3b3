// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

namespace isomatch {

/// Cuts 0..size-1 into the longest runs of which `same(i, i + 1)` holds and calls
/// `visit(first, last)` for each, in ascending order; `last` is past the end.
template <class Same, class Visit>
void for_each_run(int size, const Same& same, const Visit& visit) {
  for (int first = 0; first < size;) {
    int last = first + 1;
    while (last < size && same(last - 1, last)) ++last;
    visit(first, last);
    first = last;
  }
}

}  // namespace isomatch
