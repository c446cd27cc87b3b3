// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "input_file.h"

namespace isomatch::mesh_io {

/// The format's types of data.
enum MatType : std::uint32_t {
  kInt8 = 1,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kSingle,
  kDouble = 9,
  kInt64 = 12,
  kUint64,
  kMatrix,
  kCompressed
};

/// Its classes of arrays; those of numbers are the ones from `kDoubleClass` on.
enum MatClass : std::uint32_t { kStructClass = 2, kDoubleClass = 6, kUint64Class = 15 };

/// A matrix of numbers, column by column.
struct MatArray {
  int rows = 0;
  int columns = 0;
  std::vector<double> values;
};

/// A variable that is a matrix of numbers, a struct, or something else, which is passed over. Of an
/// array of structs it is the first one.
struct MatVariable {
  std::string name;
  std::optional<MatArray> array;
  /// The fields that are matrices of numbers; of complex ones the real parts.
  std::vector<std::pair<std::string, MatArray>> fields;
};

/// The variables of a MATLAB file of level 5, compressed or not, in either byte order. Throws
/// `BadFile` if it is malformed or of another level. Memory stays within a small multiple of the
/// uncompressed content, of which deflate can make a thousandth.
std::vector<MatVariable> read_mat_variables(const InputFile& file);

}  // namespace isomatch::mesh_io
