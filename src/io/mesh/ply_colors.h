// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <vector>

#include "io/input_file.h"
#include "io/mesh/ply_header.h"
#include "isomatch/mesh/texture.h"

namespace isomatch::mesh_io {

/// Gathers the colours of the vertices of a PLY file and brings them to [0, 1].
class PlyColors {
 public:
  static constexpr int kNoChannel = -1;

  /// Of no vertices.
  PlyColors() = default;
  /// Of an element that has each of "red", "green" and "blue" once, and no colours otherwise.
  explicit PlyColors(const PlyElement& vertex);

  bool empty() const { return channels_.empty(); }
  /// Of a property of the vertices 0, 1, 2 for red, green, blue, or `kNoChannel`.
  int channel(std::size_t property) const {
    return channels_.empty() ? kNoChannel : channels_[property];
  }
  /// Adds a vertex with the numbers in the file.
  void add(const Eigen::Vector3d& numbers) { colors_.push_back(numbers); }

  /// The colours of all vertices. What stands for full intensity depends on the type of a channel:
  /// - integers of 8 and 16 bits: the largest of the type;
  /// - integers of 32 bits: the same, but 255 if the channels of this type have nothing above it;
  /// - floating-point numbers: the least of 1, 255 and 65535 that no channel of this type exceeds.
  /// Numbers below zero are none. Throws `BadFile` if a floating-point number is larger still.
  VertexColors take(const InputFile& file);

 private:
  double full_intensity(const InputFile& file, PlyType type) const;
  double highest(PlyType type) const;

  /// For each property; empty if there are no colours.
  std::vector<int> channels_;
  std::array<PlyType, 3> types_{};
  VertexColors colors_;
};

}  // namespace isomatch::mesh_io
