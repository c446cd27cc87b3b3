// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "tracked/hypotheses.h"
#include "tracked/model.h"

namespace isomatch::tracked {

/// A hypothesis and its elastic energy.
struct Judged {
  Hypothesis hypothesis;
  double energy = 0;
  /// Which of the sources it starts from.
  const Model* source = nullptr;

  /// Energy alone misses limbs that are exchanged where they lie close together; distortion alone
  /// cannot tell front from back.
  double cost() const { return energy * hypothesis.distortion; }
};

/// Finds hypotheses and judges them, least cost first.
std::vector<Judged> judged_hypotheses(const Model& source, const Model& target,
                                      const TrackerOptions& options, const Context& context);

/// Least cost first.
void sort_by_cost(std::vector<Judged>& judged);

}  // namespace isomatch::tracked
