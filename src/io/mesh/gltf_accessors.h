// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <tiny_gltf.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/input_file.h"

namespace isomatch::mesh_io {

/// The numbers in a glTF file's buffers. Whatever leaves a buffer or is otherwise malformed is a
/// `BadFile`; nothing is allocated that the buffers do not fill.
class GltfAccessors {
 public:
  /// Keeps references to both.
  GltfAccessors(const InputFile& file, const tinygltf::Model& model);

  /// The size of all buffers.
  std::size_t total_bytes() const { return total_bytes_; }

  /// How many elements an accessor has.
  std::size_t count(int accessor) const;

  /// Throws `BadFile` unless an accessor has an element for each of so many vertices.
  void check_rows(int accessor, Eigen::Index vertices) const;

  /// The values of an accessor, a row for each element, with `components` columns. Normalised
  /// integers become fractions.
  Eigen::MatrixXd read(int accessor, int components) const;

  /// The values of an accessor of unsigned integers.
  std::vector<std::int64_t> read_indices(int accessor) const;

 private:
  /// Equal steps through a buffer view.
  struct Elements {
    const unsigned char* begin;
    std::size_t count, stride;
    int component_type;
    bool normalized;
  };
  /// Where elements are said to lie.
  struct Place {
    int view;
    std::size_t offset, count;
    int component_type;
    int components;
    bool normalized;
  };

  const tinygltf::Accessor& accessor(int index) const;
  Elements find(const Place& place) const;
  static double component(const Elements& elements, std::size_t element, int k);
  void read_sparse(const tinygltf::Accessor& accessor, Eigen::MatrixXd& values) const;
  std::vector<std::int64_t> read_integers(const Place& place) const;
  [[noreturn]] void fail(const std::string& reason) const { file_.fail(reason); }

  const InputFile& file_;
  const tinygltf::Model& model_;
  std::size_t total_bytes_ = 0;
};

}  // namespace isomatch::mesh_io
