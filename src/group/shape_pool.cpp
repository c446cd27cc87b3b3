// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/shape_pool.h"

#include <algorithm>

namespace isomatch::group {
ShapePool::ShapePool(std::span<const Shape> shapes, std::uint64_t bytes) : shapes_(shapes) {
  std::uint64_t largest = 1, all = 0;
  for (const Shape& shape : shapes) {
    largest = std::max(largest, kept_bytes(shape.num_vertices()));
    all += kept_bytes(shape.num_vertices());
  }
  most_ = all <= bytes ? shapes.size() : std::max<std::size_t>(2, bytes / largest);
}

Shape ShapePool::get(int shape) {
  if (most_ >= shapes_.size()) return shapes_[shape];
  const std::scoped_lock lock(mutex_);
  const auto known = std::ranges::find(copies_, shape, [](const auto& copy) { return copy.first; });
  if (known != copies_.end()) {
    copies_.splice(copies_.begin(), copies_, known);
  } else {
    copies_.emplace_front(shape, Shape(shapes_[shape].mesh()));
    if (copies_.size() > most_) copies_.pop_back();
  }
  return copies_.front().second;
}

}  // namespace isomatch::group
