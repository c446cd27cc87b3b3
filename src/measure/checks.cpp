// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "measure/checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "isomatch/error.h"

namespace isomatch {

void check_index(int vertex, std::size_t count) {
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= count)
    throw InvalidInput(fmt::format("vertex {} is out of range: there are {}", vertex, count));
}

void check_vertex(const Shape& shape, int vertex) { check_index(vertex, shape.num_vertices()); }

void check_targets(const Shape& target, const Correspondence& matches) {
  if (!std::ranges::is_sorted(matches)) throw InvalidInput("the correspondence is not sorted");
  for (const Match& match : matches) check_vertex(target, match.target);
}

void check_matches(const Shape& source, const Shape& target, const Correspondence& matches) {
  check_targets(target, matches);
  for (const Match& match : matches) check_vertex(source, match.source);
}

}  // namespace isomatch
