// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>

#include "isomatch/mesh.h"

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

/// A point such that the distance of two is what their positions and all other differences, as
/// weighted, amount to.
using Coordinates = std::array<double, 6 + kFeatures>;

inline Coordinates coordinates(const Point& position, const Point& normal, const Features& features,
                               const ProjectionWeights& weights) {
  Coordinates result{};
  for (int k = 0; k < 3; ++k) {
    result[k] = position[k];
    result[3 + k] = weights.normal * normal[k];
  }
  for (int k = 0; k < kReliefs; ++k) result[6 + k] = weights.relief * features.relief[k];
  for (int k = 0; k < kPlaces; ++k) result[6 + kReliefs + k] = weights.place * features.place[k];
  return result;
}

}  // namespace isomatch::elastic
