// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/input_file.h"

namespace isomatch::mesh_io {

enum class PlyFormat { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

/// Bytes that one value of `type` takes in a binary file.
int ply_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  /// Lists only: type of the number of entries that stands before them.
  std::optional<PlyType> count_type;
};

struct PlyElement {
  std::string name;
  int count = 0;
  std::vector<PlyProperty> properties;
  /// Its line in the header.
  const char* place = nullptr;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
  /// Where the content of the first element begins.
  const char* body = nullptr;

  /// The first element of this name, null if there is none.
  const PlyElement* find(std::string_view name) const;
};

/// Reads the header and checks that the rest of the file can hold all elements, and that vertices
/// occur in one element only. Throws `BadFile` with the line.
PlyHeader read_ply_header(const InputFile& file);

}  // namespace isomatch::mesh_io
