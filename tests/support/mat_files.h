// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <bit>
#include <string>
#include <string_view>
#include <vector>

/// MATLAB files of level 5 for tests.
namespace isomatch::test {

/// Builds the parts of a file in one byte order.
class MatWriter {
 public:
  explicit MatWriter(std::endian order) : order_(order) {}

  /// The file's first 128 bytes.
  std::string header() const;
  /// A variable or field: a matrix of doubles, column by column.
  std::string matrix(std::string_view name, int rows, int columns,
                     const std::vector<double>& values) const;
  /// The same stored in bytes, as MATLAB does with small integers.
  std::string byte_matrix(std::string_view name, int rows, int columns,
                          const std::vector<double>& values) const;
  /// A struct. `fields` are arrays without name; more than there are names make a row of structs.
  std::string structure(std::string_view name, const std::vector<std::string>& field_names,
                        const std::vector<std::string>& fields) const;
  std::string compressed(const std::string& variable) const;

 private:
  std::string element(unsigned type, std::string content) const;
  std::string array(unsigned array_class, int rows, int columns, std::string_view name,
                    const std::string& content) const;

  std::endian order_;
};

/// `tetrahedron()` as in TOSCA: a struct `surface` of X, Y, Z and TRIV.
std::string tetrahedron_mat(std::endian order);

}  // namespace isomatch::test
