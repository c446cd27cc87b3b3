// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <string_view>

/// Checks that all formats share. `at` is the cursor in the file, whose `fail` names the place.
namespace isomatch::mesh_io {

/// `count`, announced by the file for its elements called `name`, if it is not negative, fits an
/// int, and `available` bytes can hold so many elements of at least `bytes_each`. To be called
/// before memory is allocated.
template <class Cursor>
int checked_count(const Cursor& at, std::int64_t count, std::string_view name,
                  std::int64_t available, std::int64_t bytes_each) {
  if (count < 0) at.fail(fmt::format("the number of {} is negative ({})", name, count));
  if (count > available / bytes_each)
    at.fail(fmt::format("{} {} announced, more than the {} bytes that follow can hold", count, name,
                        available));
  if (count > std::numeric_limits<int>::max())
    at.fail(fmt::format("{} {} are more than this program can number", count, name));
  return static_cast<int>(count);
}

/// `index` if it is the 0-based number of one of `num_vertices` vertices.
template <class Cursor>
int checked_index(const Cursor& at, std::int64_t index, int num_vertices) {
  if (index < 0 || index >= num_vertices)
    at.fail(fmt::format("vertex index {} is out of range, there are {} vertices counted from 0",
                        index, num_vertices));
  return static_cast<int>(index);
}

}  // namespace isomatch::mesh_io
