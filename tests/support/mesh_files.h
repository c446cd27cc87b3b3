// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>
#include <string>
#include <string_view>

#include "isomatch/io/mesh_io.h"

/// Mesh files for tests, given by their content.
namespace isomatch::test {

/// Reads a file of this content and ending, without dot.
Mesh read_content(std::string_view ending, std::string_view content,
                  MeshReadReport* report = nullptr);

/// The message of the `BadFile` that reading this content throws, without the file's path; a remark
/// if none is thrown.
std::string read_error(std::string_view ending, std::string_view content);

/// A tetrahedron with coordinates that float holds exactly.
Mesh tetrahedron();

/// The bytes of `values`, all of type T, in this byte order.
template <class T>
std::string bytes(std::endian order, std::initializer_list<T> values) {
  std::string result;
  for (const T value : values) {
    auto part = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order != std::endian::native) std::reverse(part.begin(), part.end());
    result.append(part.data(), part.size());
  }
  return result;
}

}  // namespace isomatch::test
