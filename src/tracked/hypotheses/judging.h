// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "tracked/hypotheses/search.h"
#include "tracked/shape/pyramid.h"

namespace isomatch::tracked {

/// A hypothesis and its elastic energy.
struct Judged {
  Hypothesis hypothesis;
  double energy = 0;
  /// Which of the sources it starts from.
  const Pyramid* source = nullptr;

  /// Energy alone misses limbs that are exchanged where they lie close together; distortion alone
  /// cannot tell front from back.
  double cost() const { return energy * hypothesis.distortion; }
};

/// Hypotheses, each list with the least cost first.
struct Candidates {
  std::vector<Judged> possible;
  /// Those that were found without the landmarks and do not satisfy all of them.
  std::vector<Judged> contradicting;
};

/// Finds hypotheses and judges them.
Candidates judged_hypotheses(const Pyramid& source, const Pyramid& target, const Options& options,
                             const Context& context);

/// Whether the hypothesis sends the first of `vertices` within `slack` of the second one.
bool satisfies(const Hypothesis& hypothesis, const Match& vertices, const Pyramid& source,
               const Pyramid& target, float slack);

/// Vertices of the target's proxy at which a hypothesis puts the first `count` nodes of the source.
std::vector<int> starting_vertices(const Hypothesis& hypothesis, const Proxy& source,
                                   const Proxy& target, const elastic::Projection& surface,
                                   int count);

/// The first `count` nodes of the source that a hypothesis says something of: those that are close
/// to one that it matches. Empty where nothing is missing.
std::vector<bool> covered_nodes(const Hypothesis& hypothesis, const Pyramid& source,
                                const Pyramid& target, int count, const Options& options);

/// Least cost first.
void sort_by_cost(std::vector<Judged>& judged);

}  // namespace isomatch::tracked
