// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/random.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace isomatch::test {

Point Random::direction() {
  const double z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Eigen::Matrix3d Random::rotation() {
  // Shoemake, "Uniform random rotations", Graphics Gems III.
  const double u = uniform(), a = uniform(0, 2 * std::numbers::pi);
  const double b = uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - u), s = std::sqrt(u);
  return Eigen::Quaterniond(s * std::cos(b), r * std::sin(a), r * std::cos(a), s * std::sin(b))
      .toRotationMatrix();
}

std::vector<int> Random::permutation(int size) {
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  for (int i = size - 1; i > 0; --i) std::swap(order[i], order[index(i + 1)]);
  return order;
}

}  // namespace isomatch::test
