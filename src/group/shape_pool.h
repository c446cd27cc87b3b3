// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <list>
#include <mutex>
#include <span>
#include <utility>

#include "isomatch/shape/shape.h"

namespace isomatch::group {

/// Shapes for matching, which keeps with them what it prepares. If all of that would take more
/// memory than is allowed, copies are handed out, of which those that were not asked for the
/// longest are let go. Safe to use from several threads.
class ShapePool {
 public:
  ShapePool(std::span<const Shape> shapes, std::uint64_t bytes);

  Shape get(int shape);

 private:
  std::span<const Shape> shapes_;
  /// Copies that are kept at most; none are made if it is all.
  std::size_t most_;
  std::mutex mutex_;
  std::list<std::pair<int, Shape>> copies_;  ///< The one that was asked for last comes first.
};

}  // namespace isomatch::group
