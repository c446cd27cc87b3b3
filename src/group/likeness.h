// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "group/places.h"
#include "isomatch/context.h"

namespace isomatch::group {

/// How alike shapes are whose points correspond: distances in space between points of the template
/// that are near each other on it, which bending changes little and stretching much.
class Likeness {
 public:
  /// `places` are of each shape, see `Places`. O(N P).
  Likeness(const std::vector<const Surface*>& surfaces, const std::vector<Places>& places,
           int template_shape, const Context& context);

  /// Root mean square difference of the distances that both shapes have; infinite if there are
  /// none.
  double difference(int a, int b) const;
  /// Of the shapes that may be chosen the one with the least mean difference from all.
  int most_central(const std::vector<bool>& eligible) const;
  /// Of the others the `count` that are most like a shape, the most alike first.
  std::vector<int> nearest(int shape, int count) const;

 private:
  /// A row a shape, NaN where an end is missing.
  std::vector<std::vector<float>> lengths_;
};

}  // namespace isomatch::group
