// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/gltf_accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/byte_order.h"
#include "io/mesh/checks.h"

namespace isomatch::mesh_io {
namespace {

enum ComponentType { kInt8 = 5120, kUint8, kInt16, kUint16, kUint32 = 5125, kFloat = 5126 };

std::size_t component_size(int type) {
  switch (type) {
    case kInt8:
    case kUint8:
      return 1;
    case kInt16:
    case kUint16:
      return 2;
    case kUint32:
    case kFloat:
      return 4;
    default:
      return 0;
  }
}

/// The file's integer as such, or with 1 for `largest`.
double integer(double value, bool normalized, double largest) {
  return normalized ? std::max(value / largest, -1.0) : value;
}

}  // namespace

GltfAccessors::GltfAccessors(const InputFile& file, const tinygltf::Model& model)
    : file_(file), model_(model) {
  for (const tinygltf::Buffer& buffer : model.buffers) total_bytes_ += buffer.data.size();
}

const tinygltf::Accessor& GltfAccessors::accessor(int index) const {
  if (index < 0 || index >= std::ssize(model_.accessors))
    fail(fmt::format("accessor {} is out of range, there are {}", index, model_.accessors.size()));
  const tinygltf::Accessor& found = model_.accessors[index];
  // A sparse accessor may announce any number of zeros.
  if (found.count > total_bytes_)
    fail(fmt::format("accessor {} announces {} elements, more than the {} bytes of the buffers",
                     index, found.count, total_bytes_));
  return found;
}

std::size_t GltfAccessors::count(int index) const { return accessor(index).count; }

void GltfAccessors::check_rows(int index, Eigen::Index vertices) const {
  if (std::cmp_not_equal(count(index), vertices))
    fail(fmt::format("accessor {} has {} elements for {} vertices", index, count(index), vertices));
}

GltfAccessors::Elements GltfAccessors::find(const Place& place) const {
  if (place.view < 0 || place.view >= std::ssize(model_.bufferViews))
    fail(fmt::format("buffer view {} is out of range, there are {}", place.view,
                     model_.bufferViews.size()));
  const tinygltf::BufferView& view = model_.bufferViews[place.view];
  if (view.buffer < 0 || view.buffer >= std::ssize(model_.buffers))
    fail(
        fmt::format("buffer {} is out of range, there are {}", view.buffer, model_.buffers.size()));
  const std::vector<unsigned char>& buffer = model_.buffers[view.buffer].data;
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
    fail(fmt::format("buffer view {} leaves its buffer of {} bytes", place.view, buffer.size()));
  const std::size_t part = component_size(place.component_type);
  if (part == 0) fail(fmt::format("{} is no type of numbers", place.component_type));
  const std::size_t size = part * place.components;
  const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
  const std::size_t length = view.byteLength;
  const bool fits = place.count == 0 ||
                    (place.offset <= length && length - place.offset >= size && stride >= size &&
                     (length - place.offset - size) / stride >= place.count - 1);
  if (!fits)
    fail(fmt::format("{} elements do not fit into buffer view {} of {} bytes", place.count,
                     place.view, length));
  // Past the buffer's end only if there is nothing to read.
  return {buffer.data() + view.byteOffset + std::min(place.offset, length), place.count, stride,
          place.component_type, place.normalized};
}

double GltfAccessors::component(const Elements& elements, std::size_t element, int k) {
  const char* const bytes = reinterpret_cast<const char*>(elements.begin) +
                            element * elements.stride + k * component_size(elements.component_type);
  const bool normalized = elements.normalized;
  switch (elements.component_type) {
    case kInt8:
      return integer(load<std::int8_t>(bytes), normalized, 127);
    case kUint8:
      return integer(load<std::uint8_t>(bytes), normalized, 255);
    case kInt16:
      return integer(load<std::int16_t>(bytes), normalized, 32767);
    case kUint16:
      return integer(load<std::uint16_t>(bytes), normalized, 65535);
    case kUint32:
      return integer(load<std::uint32_t>(bytes), normalized, 4294967295.0);
    default:
      return load<float>(bytes);
  }
}

Eigen::MatrixXd GltfAccessors::read(int index, int components) const {
  const tinygltf::Accessor& found = accessor(index);
  if (tinygltf::GetNumComponentsInType(found.type) != components)
    fail(fmt::format("accessor {} does not have {} components", index, components));
  const auto rows = static_cast<Eigen::Index>(found.count);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(rows, components);
  if (found.bufferView >= 0) {
    const Elements elements = find({found.bufferView, found.byteOffset, found.count,
                                    found.componentType, components, found.normalized});
    for (Eigen::Index i = 0; i < rows; ++i)
      for (int k = 0; k < components; ++k) values(i, k) = component(elements, i, k);
  } else if (!found.sparse.isSparse) {
    fail(fmt::format("accessor {} has no data", index));
  }
  if (found.sparse.isSparse) read_sparse(found, values);
  return values;
}

void GltfAccessors::read_sparse(const tinygltf::Accessor& found, Eigen::MatrixXd& values) const {
  const auto& [count, is_sparse, indices, replacements] = found.sparse;
  if (count < 0 || indices.byteOffset < 0 || replacements.byteOffset < 0)
    fail("a sparse accessor has a negative number");
  const auto size = static_cast<std::size_t>(count);
  const std::vector<std::int64_t> rows =
      read_integers({indices.bufferView, static_cast<std::size_t>(indices.byteOffset), size,
                     indices.componentType, 1, false});
  const int components = static_cast<int>(values.cols());
  const Elements elements =
      find({replacements.bufferView, static_cast<std::size_t>(replacements.byteOffset), size,
            found.componentType, components, found.normalized});
  for (std::size_t i = 0; i < size; ++i) {
    if (rows[i] >= values.rows())
      fail(fmt::format("a sparse accessor replaces element {} of {}", rows[i], values.rows()));
    for (int k = 0; k < components; ++k) values(rows[i], k) = component(elements, i, k);
  }
}

std::vector<std::int64_t> GltfAccessors::read_integers(const Place& place) const {
  if (place.component_type != kUint8 && place.component_type != kUint16 &&
      place.component_type != kUint32)
    fail("indices must be unsigned integers");
  const Elements elements = find(place);
  std::vector<std::int64_t> integers;
  integers.reserve(place.count);
  for (std::size_t i = 0; i < place.count; ++i)
    integers.push_back(static_cast<std::int64_t>(component(elements, i, 0)));
  return integers;
}

std::vector<std::int64_t> GltfAccessors::read_indices(int index) const {
  const tinygltf::Accessor& found = accessor(index);
  if (found.type != TINYGLTF_TYPE_SCALAR || found.sparse.isSparse)
    fail(fmt::format("accessor {} does not hold plain indices", index));
  return read_integers(
      {found.bufferView, found.byteOffset, found.count, found.componentType, 1, false});
}

}  // namespace isomatch::mesh_io
