// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.h"
#include "isomatch/io/atomic_file.h"

namespace isomatch {

/// An array of numpy, in C order. Integers beyond 2^53 are rounded.
struct NpyArray {
  std::vector<std::int64_t> shape;
  std::vector<double> values;
  /// What a file is to hold, or held.
  bool has_integers = false;
};

/// Named arrays.
using NpzArrays = std::map<std::string, NpyArray>;

/// The arrays of numbers in an .npz file, compressed or not; arrays of anything else are left out.
/// Throws `BadFile` if it is malformed. Memory follows what there is, not what is announced.
NpzArrays read_npz(const InputFile& file);

/// Writes arrays of 64-bit integers and floats. The same arrays give the same bytes.
void write_npz(const NpzArrays& arrays, AtomicFile& file);

/// The content of one .npy file; nothing if it holds no numbers. `BadFile` names `name` in `file`.
std::optional<NpyArray> parse_npy(const InputFile& file, const std::string& name,
                                  std::string_view content);

std::string npy_bytes(const NpyArray& array);

/// What stands before the data of an array; `type` in numpy's spelling.
std::string npy_header(std::string_view type, const std::vector<std::int64_t>& shape);

/// Writes the contents of .npy files by the names of the arrays.
void write_npy_files(const std::map<std::string, std::string>& contents, AtomicFile& file);

}  // namespace isomatch
