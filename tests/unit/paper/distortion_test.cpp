// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/distortion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/methods/paper.h"
#include "support/context.h"
#include "support/metric_surface.h"
#include "support/random.h"
#include "support/rough_meshes.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

/// Rounding of distances to float, which are at most 1 after normalisation.
constexpr double kFloat = 1e-6;

/// Two shapes, some vertices of each as rows, and a list of matches between rows.
struct Pair {
  MetricSurface source = test::metric_surface(test::rough_sphere(3, 0.2, 1));
  MetricSurface target = test::metric_surface(test::rough_sphere(3, 0.1, 2));
  std::vector<int> source_rows = test::Random(3).permutation(source.num_vertices());
  std::vector<int> target_rows = test::Random(4).permutation(target.num_vertices());
  Correspondence list;

  Pair(int num_rows, int list_size) {
    source_rows.resize(num_rows);
    target_rows.resize(num_rows);
    test::Random random(5);
    const std::vector<int> sources = random.permutation(num_rows);
    for (int e = 0; e < list_size; ++e) list.push_back({sources[e], random.index(num_rows)});
  }

  /// Equation 2 for the match of two rows, its own source left out of the list.
  double plain_distortion(int source_row, int target_row) const {
    GeodesicSearch source_search(source.graph()), target_search(target.graph());
    double sum = 0;
    int count = 0;
    for (const Match& match : list) {
      if (match.source == source_row) continue;
      const double g_source =
          source_search.distance(source_rows[match.source], source_rows[source_row]);
      const double g_target =
          target_search.distance(target_rows[match.target], target_rows[target_row]);
      sum += std::abs(g_source / source.max_geodesic() - g_target / target.max_geodesic());
      ++count;
    }
    return count == 0 ? 0 : sum / count;
  }
};

MatchDistortion distortion_of(const Pair& pair, FieldStore& source_fields,
                              FieldStore& target_fields, const Context& context = {}) {
  return {source_fields, pair.source_rows, target_fields, pair.target_rows, pair.list, context};
}

MatchDistortion distortion_of(const Pair& pair) {
  FieldStore source_fields(pair.source), target_fields(pair.target);
  return distortion_of(pair, source_fields, target_fields);
}

TEST(MatchDistortion, IsEquationTwoWithoutTheMatchItself) {
  for (const int list_size : {1, 2, 7, 20}) {
    const Pair pair(20, list_size);
    const MatchDistortion distortion = distortion_of(pair);
    EXPECT_EQ(distortion.list_size(), list_size);
    for (int s = 0; s < 20; ++s) {
      for (int t = 0; t < 20; ++t)
        EXPECT_NEAR(distortion(s, t), pair.plain_distortion(s, t), kFloat);
    }
  }
}

TEST(MatchDistortion, LeavesTheSourceOutWhateverItsTarget) {
  // With a single match in the list, nothing is left to compare its source with.
  const Pair pair(10, 1);
  const MatchDistortion distortion = distortion_of(pair);
  for (int t = 0; t < 10; ++t) EXPECT_EQ(distortion(pair.list.front().source, t), 0);
}

TEST(MatchDistortion, IsZeroAgainstAnEmptyList) {
  const Pair pair(5, 0);
  const MatchDistortion distortion = distortion_of(pair);
  EXPECT_EQ(distortion.list_size(), 0);
  EXPECT_EQ(distortion(2, 3), 0);
  EXPECT_EQ(MatchDistortion{}.list_size(), 0);
}

TEST(MatchDistortion, IsZeroForTheIdentityAndThenOnly) {
  const MetricSurface shape = test::metric_surface(test::rough_sphere(3, 0.2, 6));
  std::vector<int> rows(shape.num_vertices());
  std::iota(rows.begin(), rows.end(), 0);
  Correspondence list;
  for (int v = 0; v < shape.num_vertices(); v += 40) list.push_back({v, v});
  FieldStore a(shape), b(shape);
  const MatchDistortion distortion(a, rows, b, rows, list);
  for (int v : rows) {
    ASSERT_EQ(distortion(v, v), 0);
    ASSERT_GT(distortion(v, (v + 1) % shape.num_vertices()), 0);
  }
}

TEST(MatchDistortion, RejectsASourceThatIsListedTwice) {
  Pair pair(10, 5);
  pair.list.push_back({pair.list[2].source, 0});
  EXPECT_THROW(distortion_of(pair), InvalidInput);
  pair.list.back() = pair.list[2];
  EXPECT_THROW(distortion_of(pair), InvalidInput);
}

TEST(MatchDistortion, AllowsATargetThatIsListedTwice) {
  Pair pair(10, 5);
  for (Match& match : pair.list) match.target = 3;
  const MatchDistortion distortion = distortion_of(pair);
  for (int s = 0; s < 10; ++s) EXPECT_NEAR(distortion(s, 3), pair.plain_distortion(s, 3), kFloat);
}

TEST(MatchDistortion, CapacityOfTheStoresAndThreadsChangeNothing) {
  const Pair pair(30, 20);
  const MatchDistortion expected = distortion_of(pair);
  for (const int capacity : {0, 1, 7, 20}) {
    FieldStore source_fields(pair.source, capacity), target_fields(pair.target, capacity);
    for (const int threads : {1, 3}) {
      const MatchDistortion distortion =
          distortion_of(pair, source_fields, target_fields, test::with_threads(threads));
      for (int row = 0; row < 30; ++row)
        EXPECT_EQ(distortion(row, 29 - row), expected(row, 29 - row));
    }
  }
}

/// `source`'s field over the largest distance.
std::vector<float> plain_field(const MetricSurface& shape, int source) {
  std::vector<float> field(shape.num_vertices());
  GeodesicSearch(shape.graph()).field(source, field);
  for (float& distance : field) distance *= static_cast<float>(1 / shape.max_geodesic());
  return field;
}

TEST(FieldStore, GivesNormalizedFieldsWhateverItStillHolds) {
  const MetricSurface shape = test::metric_surface(test::jittered_torus(24, 12, 0.3, 1));
  FieldStore store(shape, 4);
  EXPECT_EQ(&store.shape(), &shape);
  test::Random random(1);
  for (int request = 0; request < 20; ++request) {
    std::vector<int> sources(1 + random.index(8));
    for (int& source : sources) source = random.index(12);
    const auto fields = store.fields(sources);
    ASSERT_EQ(fields.size(), sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
      ASSERT_TRUE(std::ranges::equal(fields[i], plain_field(shape, sources[i])));
  }
  EXPECT_TRUE(store.fields({}).empty());
}

TEST(FieldStore, ReachesOneAtTheFarthestVertex) {
  const MetricSurface shape = test::metric_surface(test::icosphere(3));
  FieldStore store(shape);
  const std::vector<int> sources{0, 100, 641};
  for (const auto& field : store.fields(sources)) {
    // From any vertex of a sphere its antipode is about as far as two points can be.
    EXPECT_GT(std::ranges::max(field), 0.98);
    EXPECT_LE(std::ranges::max(field), 1 + kFloat);
  }
}

TEST(LandmarkDistances, HaveARowAVertexAndAColumnALandmark) {
  const MetricSurface shape = test::metric_surface(test::icosphere(2));
  FieldStore store(shape);
  const std::vector<int> rows{5, 80, 5}, landmarks{7, 5, 7, 161};
  const LandmarkDistances distances(store, rows, landmarks);
  EXPECT_EQ(distances.num_landmarks(), 4);
  for (int row = 0; row < 3; ++row) {
    ASSERT_EQ(distances.row(row).size(), 4);
    for (int column = 0; column < 4; ++column)
      EXPECT_EQ(distances.row(row)[column], plain_field(shape, landmarks[column])[rows[row]]);
  }
}

TEST(Summarize, GivesMeanAndMaximumOfTheMatches) {
  const Pair pair(20, 10);
  const MatchDistortion distortion = distortion_of(pair);
  const Correspondence matches{{0, 3}, {0, 5}, {7, 3}, {19, 0}};
  double sum = 0, largest = 0;
  for (const Match& match : matches) {
    const double value = pair.plain_distortion(match.source, match.target);
    sum += value;
    largest = std::max(largest, value);
  }
  const DistortionSummary summary = summarize(distortion.of(matches));
  EXPECT_NEAR(summary.mean, sum / 4, kFloat);
  EXPECT_NEAR(summary.max, largest, kFloat);
  EXPECT_EQ(summarize({}).mean, 0);
  EXPECT_EQ(summarize({}).max, 0);
}

}  // namespace
}  // namespace isomatch
