// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "support/random.h"
#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch {

/// Lets GoogleTest name a match.
// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for.
void PrintTo(const Match& match, std::ostream* stream) {
  *stream << match.source << ':' << match.target;
}

namespace tracked {
namespace {

/// A proxy of which only the distances between nodes are known: those of `points`.
Proxy proxy_of(const std::vector<Point>& points) {
  Proxy proxy;
  const auto n = static_cast<int>(points.size());
  proxy.nodes.resize(n);
  std::iota(proxy.nodes.begin(), proxy.nodes.end(), 0);
  proxy.distances.resize(n, n);
  proxy.to_boundary.assign(n, std::numeric_limits<float>::infinity());
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      proxy.distances(a, b) = static_cast<float>((points[a] - points[b]).norm());
  return proxy;
}

std::vector<Point> random_points(int count, test::Random& random) {
  std::vector<Point> points(count);
  for (Point& p : points) p = Point(random.uniform(), random.uniform(), 0);
  return points;
}

std::vector<int> first_numbers(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

struct ScoredMatching {
  double score;
  Correspondence matches;
};

/// All partial injective matchings in which the first `fixed` nodes of both sets match, by plain
/// enumeration.
class PlainSeeds {
 public:
  PlainSeeds(const Proxy& source, const Proxy& target, int fixed, const SeedOptions& options)
      : source_(source), target_(target), fixed_(fixed), options_(options) {
    Correspondence given;
    for (int i = 0; i < fixed; ++i) given.push_back({i, i});
    extend(fixed, given);
    std::ranges::stable_sort(found_, std::greater(), &ScoredMatching::score);
  }

  const std::vector<ScoredMatching>& found() const { return found_; }

  /// Sum over pairs of matches that are not both given; very low if one is not compatible.
  double score(const Correspondence& matches) const {
    double sum = 0;
    for (std::size_t i = 0; i < matches.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (std::cmp_less(i, fixed_)) continue;
        const double difference =
            std::abs(source_.node_distance(matches[i].source, matches[j].source) -
                     target_.node_distance(matches[i].target, matches[j].target));
        if (difference > options_.max_difference) return -1e9;
        sum += options_.neutral_difference - difference;
      }
    }
    return sum;
  }

 private:
  void extend(int tip, const Correspondence& matches) {
    if (tip == source_.num_nodes()) {
      const bool enough = std::ssize(matches) >= std::max(options_.min_matches, fixed_);
      if (enough && score(matches) > -1e8) found_.push_back({score(matches), matches});
      return;
    }
    extend(tip + 1, matches);
    for (int t = 0; t < target_.num_nodes(); ++t) {
      if (std::ranges::find(matches, t, &Match::target) != matches.end()) continue;
      Correspondence more = matches;
      more.push_back({tip, t});
      extend(tip + 1, more);
    }
  }

  const Proxy& source_;
  const Proxy& target_;
  int fixed_;
  const SeedOptions& options_;
  std::vector<ScoredMatching> found_;
};

/// That the seeds are the best of all matchings, best first.
void expect_best(const Proxy& source, const Proxy& target, int fixed, const SeedOptions& options) {
  const std::vector<Correspondence> seeds =
      seed_matchings(source, first_numbers(source.num_nodes()), target,
                     first_numbers(target.num_nodes()), fixed, options);
  const PlainSeeds plain(source, target, fixed, options);
  ASSERT_EQ(seeds.size(), std::min<std::size_t>(plain.found().size(), options.max_seeds));
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    // Equal up to rounding of the sums.
    EXPECT_NEAR(plain.score(seeds[i]), plain.found()[i].score, 1e-9);
    EXPECT_GE(std::ssize(seeds[i]), options.min_matches);
    EXPECT_EQ(std::ranges::count(seeds, seeds[i]), 1);
    for (int k = 0; k < fixed; ++k) EXPECT_EQ(seeds[i][k], (Match{k, k}));
  }
}

TEST(SeedMatchings, AreTheBestOfAllPartialMatchings) {
  test::Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    SeedOptions options;
    options.max_difference = random.uniform(0.1, 0.6);
    options.neutral_difference = random.uniform(0.05, 0.3);
    options.min_matches = 1 + random.index(4);
    options.max_seeds = 1 + random.index(60);
    const Proxy source = proxy_of(random_points(2 + random.index(4), random));
    const Proxy target = proxy_of(random_points(2 + random.index(4), random));
    for (int fixed = 0; fixed <= 2; ++fixed) expect_best(source, target, fixed, options);
  }
}

TEST(SeedMatchings, BeginWithTheIdentityOfAShapeOntoItself) {
  test::Random random(2);
  const Proxy proxy = proxy_of(random_points(7, random));
  const std::vector<int> tips = first_numbers(7);
  Correspondence identity;
  for (int tip : tips) identity.push_back({tip, tip});
  const auto seeds = seed_matchings(proxy, tips, proxy, tips, 0, {});
  ASSERT_FALSE(seeds.empty());
  EXPECT_EQ(seeds.front(), identity);
}

TEST(SeedMatchings, NameTheNodesOfTheTips) {
  test::Random random(3);
  const Proxy proxy = proxy_of(random_points(9, random));
  const std::vector<int> source_tips{8, 2, 5, 1}, target_tips{2, 8, 1, 5};
  const auto seeds = seed_matchings(proxy, source_tips, proxy, target_tips, 0, {});
  ASSERT_FALSE(seeds.empty());
  Correspondence best = seeds.front();
  std::ranges::sort(best);
  EXPECT_EQ(best, (Correspondence{{1, 1}, {2, 2}, {5, 5}, {8, 8}}));
}

TEST(SeedMatchings, AreBoundedInNumberAndWork) {
  // Of equal distances every matching of ten tips is as good as every other: some 2e8 in all.
  const Proxy proxy = proxy_of(std::vector<Point>(10, Point::Zero()));
  const std::vector<int> tips = first_numbers(10);
  SeedOptions options;
  options.max_seeds = 50;
  options.max_visits = 10000;
  const auto seeds = seed_matchings(proxy, tips, proxy, tips, 0, options);
  EXPECT_EQ(seeds.size(), 50);
  for (const Correspondence& seed : seeds) EXPECT_GE(seed.size(), 4);
}

TEST(SeedMatchings, OfTooFewTipsAreNone) {
  test::Random random(4);
  const Proxy proxy = proxy_of(random_points(5, random));
  EXPECT_TRUE(seed_matchings(proxy, {}, proxy, {}, 0, {}).empty());
  EXPECT_TRUE(seed_matchings(proxy, {1, 2, 3}, proxy, {0, 1, 2, 3, 4}, 0, {}).empty());
}

/// Of each node the integral of the distances to all of the surface.
std::vector<double> integrals(const Proxy& proxy) {
  const std::vector<double> areas = vertex_areas(proxy.mesh);
  std::vector<double> result(proxy.nodes.size(), 0.0);
  for (int a = 0; a < proxy.num_nodes(); ++a)
    for (int v = 0; v < proxy.num_vertices(); ++v) result[a] += areas[v] * proxy.distances(a, v);
  return result;
}

TEST(Extremities, AreLocalMaximaSpreadApart) {
  SeedOptions options;
  for (const int seed : {1, 2, 3}) {
    const auto& mesh = synthesize({.vertices = 1500, .pose = 1, .seed = std::uint64_t(seed)}).mesh;
    const Proxy proxy =
        test::Prepared(mesh, {.vertices = 1500, .nodes = 500, .measured_nodes = 500}).proxy;
    const std::vector<double> integral = integrals(proxy);
    const std::vector<int> tips = extremities(proxy, options);
    EXPECT_GE(tips.size(), 4);  // Creatures have at least as many limbs.
    EXPECT_LE(std::ssize(tips), options.max_extremities);
    EXPECT_EQ(integral[tips.front()], std::ranges::max(integral));
    const auto gap = [&](std::size_t i, int node) {
      return std::ranges::min(std::span(tips).first(i) | std::views::transform([&](int tip) {
                                return proxy.node_distance(tip, node);
                              }));
    };
    for (std::size_t i = 1; i < tips.size(); ++i)
      for (std::size_t j = i; j < tips.size(); ++j) EXPECT_GE(gap(i, tips[i]), gap(i, tips[j]));
    for (int tip : tips) {
      for (int node = 0; node < proxy.num_nodes(); ++node) {
        if (proxy.node_distance(tip, node) > options.extremity_radius) continue;
        EXPECT_LE(integral[node], integral[tip]);
      }
    }
  }
}

TEST(Extremities, OfARodAreItsEnds) {
  const test::Prepared rod(test::closed_cylinder(12, 100, 0.1, 10));
  const std::vector<int> tips = extremities(rod.proxy, {});
  ASSERT_GE(tips.size(), 2);
  double lowest = 1e9, highest = -1e9;
  for (const Point& p : rod.proxy.mesh.vertices) {
    lowest = std::min(lowest, p.z());
    highest = std::max(highest, p.z());
  }
  for (int tip : tips) {
    const double z = rod.proxy.node_position(tip).z();
    EXPECT_LT(std::min(z - lowest, highest - z), 0.1 * (highest - lowest));
  }
}

TEST(Extremities, AreNoMoreThanWanted) {
  SeedOptions options;
  const Proxy proxy = test::Prepared(test::icosphere(2)).proxy;
  for (options.max_extremities = 1; options.max_extremities < 20; ++options.max_extremities)
    EXPECT_LE(std::ssize(extremities(proxy, options)), options.max_extremities);
}

}  // namespace
}  // namespace tracked
}  // namespace isomatch
