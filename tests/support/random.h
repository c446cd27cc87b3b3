// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <random>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::test {

/// Random numbers that are the same with every standard library (the distributions of <random> are
/// not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0..size-1. The bias of the remainder is below size / 2^64.
  int index(int size) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(size)); }
  /// Uniform on the unit sphere.
  Point direction();
  /// A uniformly distributed rotation.
  Eigen::Matrix3d rotation();
  /// 0..size-1 in random order.
  std::vector<int> permutation(int size);

 private:
  std::mt19937_64 engine_;
};

}  // namespace isomatch::test
