// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>

namespace isomatch::elastic {

/// What tells points of a surface apart besides position and normal: how far they stand out at
/// several scales, and where on the surface they are, as distances along it from a few of its
/// points. The latter keep limbs apart that touch.
inline constexpr int kReliefs = 3;
inline constexpr int kPlaces = 5;
inline constexpr int kFeatures = kReliefs + kPlaces;
struct Features {
  std::array<double, kReliefs> relief{};
  std::array<double, kPlaces> place{};
};

/// How much other differences count, as distances.
struct ProjectionWeights {
  double normal = 0.2;
  double relief = 0.05;
  double place = 0;
};

}  // namespace isomatch::elastic
