// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "gmds/coarse_start.h"

#include <algorithm>

namespace isomatch::baselines {
namespace {

struct Partial {
  std::vector<int> candidates;
  double stress = 0;
};

void keep_best(std::vector<Partial>& partials, std::size_t count) {
  std::ranges::sort(partials, [](const Partial& a, const Partial& b) {
    return std::pair(a.stress, a.candidates) < std::pair(b.stress, b.candidates);
  });
  if (partials.size() > count) partials.resize(count);
}

/// `partial` with every candidate for the next point.
void extend(const Partial& partial, const Eigen::MatrixXd& wanted, const Eigen::MatrixXd& given,
            std::vector<Partial>& extended) {
  const int next = static_cast<int>(partial.candidates.size());
  for (int candidate = 0; candidate < given.rows(); ++candidate) {
    if (std::ranges::count(partial.candidates, candidate) > 0) continue;
    Partial longer = partial;
    for (int j = 0; j < next; ++j) {
      const double difference = given(candidate, partial.candidates[j]) - wanted(next, j);
      longer.stress += difference * difference;
    }
    longer.candidates.push_back(candidate);
    extended.push_back(std::move(longer));
  }
}

}  // namespace

std::vector<std::vector<int>> coarse_assignments(const Eigen::MatrixXd& wanted, int points,
                                                 const Eigen::MatrixXd& given, int beam,
                                                 int count) {
  std::vector<Partial> partials(1);
  for (int next = 0; next < points; ++next) {
    std::vector<Partial> extended;
    for (const Partial& partial : partials) extend(partial, wanted, given, extended);
    keep_best(extended, beam);
    partials = std::move(extended);
  }
  keep_best(partials, count);
  std::vector<std::vector<int>> assignments;
  for (Partial& partial : partials) assignments.push_back(std::move(partial.candidates));
  return assignments;
}

}  // namespace isomatch::baselines
