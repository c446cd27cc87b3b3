// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel.h"

namespace isomatch::tracked {
namespace {

/// For each source landmark those of the target that look most like it.
Correspondence alike_landmarks(const FloatMatrix& source, const FloatMatrix& target, int count) {
  Correspondence matches;
  std::vector<float> difference(target.rows());
  std::vector<int> order(target.rows());
  for (Eigen::Index s = 0; s < source.rows(); ++s) {
    for (Eigen::Index t = 0; t < target.rows(); ++t)
      difference[t] = (source.row(s) - target.row(t)).lpNorm<1>();
    std::iota(order.begin(), order.end(), 0);
    const auto kept = std::min<std::ptrdiff_t>(count, std::ssize(order));
    std::ranges::partial_sort(order, order.begin() + kept, {},
                              [&](int t) { return difference[t]; });
    for (std::ptrdiff_t k = 0; k < kept; ++k) matches.push_back({static_cast<int>(s), order[k]});
  }
  return matches;
}

/// How well each two matches agree: 1 where distances are the same, 0 from a tolerance on.
FloatMatrix agreement_of(const Correspondence& matches, const NodeDirections& source,
                         const NodeDirections& target, const LocalShapeOptions& options) {
  const auto n = static_cast<Eigen::Index>(matches.size());
  FloatMatrix agreement = FloatMatrix::Zero(n, n);
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index b = 0; b < a; ++b) {
      const auto [s, t] = matches[a];
      const auto [other_s, other_t] = matches[b];
      if (s == other_s || t == other_t) continue;
      const float d =
          doubted_difference(source, {s, other_s}, target, {t, other_t}, options.doubt) /
          options.tolerable_difference;
      agreement(a, b) = agreement(b, a) = std::max(0.0F, 1 - d * d);
    }
  return agreement;
}

struct Cluster {
  Correspondence matches;
  float score = 0;
};

/// Agreement of a match of a landmark that has another one.
constexpr float kUsed = -1e6F;

/// From one match on, as long as others agree with those that are there.
Cluster grown_cluster(Eigen::Index seed, const Correspondence& matches,
                      const FloatMatrix& agreement, float least) {
  Cluster cluster{{matches[seed]}, 0};
  Eigen::RowVectorXf sum = agreement.row(seed);
  const auto drop_rivals = [&](const Match& match) {
    for (Eigen::Index k = 0; k < sum.size(); ++k)
      if (matches[k].source == match.source || matches[k].target == match.target) sum[k] = kUsed;
  };
  drop_rivals(matches[seed]);
  for (;;) {
    Eigen::Index best = 0;
    const auto size = static_cast<float>(cluster.matches.size());
    if (sum.maxCoeff(&best) < least * size) break;
    cluster.score += sum[best] / size;
    cluster.matches.push_back(matches[best]);
    sum += agreement.row(best);
    drop_rivals(matches[best]);
  }
  return cluster;
}

}  // namespace

std::vector<Correspondence> agreeing_clusters(
    const NodeDirections& source, const FloatMatrix& source_shapes, const NodeDirections& target,
    const FloatMatrix& target_shapes, const LocalShapeOptions& options, const Context& context) {
  const Correspondence matches =
      alike_landmarks(source_shapes, target_shapes, options.alike_landmarks);
  const FloatMatrix agreement = agreement_of(matches, source, target, options);
  std::vector<Cluster> clusters(matches.size());
  parallel_for(std::ssize(clusters), context, [&](std::ptrdiff_t k) {
    clusters[k] = grown_cluster(k, matches, agreement, options.least_agreement);
  });
  std::ranges::stable_sort(clusters, std::greater(), &Cluster::score);
  std::vector<Correspondence> result;
  for (Cluster& cluster : clusters) result.push_back(std::move(cluster.matches));
  return result;
}

}  // namespace isomatch::tracked
