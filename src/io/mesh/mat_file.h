// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/input_file.h"

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

/// A variable or a field: a matrix of numbers, of complex ones the real parts, a struct, or
/// something else, which is passed over.
struct MatVariable {
  std::string name;
  std::optional<MatArray> array;
  /// Of a struct. An array of several structs has them for fields, called "(1)", "(2)" and so on.
  std::vector<MatVariable> fields;
};

/// The variables of a MATLAB file of level 5, compressed or not, in either byte order. Throws
/// `BadFile` if it is malformed or of another level. Structs nested deeper than a few levels are
/// passed over. Memory stays within a small multiple of the uncompressed content, of which deflate
/// can make a thousandth.
std::vector<MatVariable> read_mat_variables(const InputFile& file);

}  // namespace isomatch::mesh_io
