// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace isomatch {

/// An array of numpy: its extents, and as many values, the last index running fastest.
struct NumpyArray {
  std::vector<std::int64_t> shape;
  /// In numpy: float64, int32, bool, and str; texts are UTF-8, and what is not becomes U+FFFD.
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<bool>,
               std::vector<std::string>>
      values;
};

/// Writes arrays by their names as an .npz file, which `numpy.load` reads. The file appears whole
/// or not at all; the same arrays give the same bytes. Throws `InvalidInput` if the values of an
/// array are not as many as its shape says, `BadFile` if the file cannot be written.
void write_arrays(const std::string& path, const std::map<std::string, NumpyArray>& arrays);

}  // namespace isomatch
