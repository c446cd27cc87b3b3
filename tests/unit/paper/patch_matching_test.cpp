// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/patch_matching.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "isomatch/error.h"
#include "support/random.h"

namespace isomatch {
namespace {

/// Sums of some 60 floats below 1.
constexpr float kRounding = 1e-5f;

Eigen::MatrixXf random_distances(int count, test::Random& random) {
  Eigen::MatrixXf distances = Eigen::MatrixXf::Zero(count, count);
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < a; ++b)
      distances(a, b) = distances(b, a) = static_cast<float>(random.uniform());
  }
  return distances;
}

PatchProblem random_problem(int rows, int columns, test::Random& random) {
  PatchProblem problem{random_distances(rows, random), random_distances(columns, random),
                       Eigen::MatrixXf(rows, columns)};
  for (float& sum : problem.list_distortion.reshaped()) sum = static_cast<float>(random.uniform());
  return problem;
}

/// All numbers rounded to multiples of 1/2, exact in float, so that many matchings cost the same.
PatchProblem with_ties(PatchProblem problem) {
  for (Eigen::MatrixXf* matrix :
       {&problem.source_distances, &problem.target_distances, &problem.list_distortion})
    *matrix = (*matrix * 2).array().round() / 2;
  return problem;
}

/// Equation 1 times the number of matches: each row against the list and all other rows.
float plain_cost(const PatchProblem& problem, const std::vector<int>& column_of_row) {
  float cost = 0;
  for (int row = 0; row < static_cast<int>(column_of_row.size()); ++row) {
    cost += problem.list_distortion(row, column_of_row[row]);
    for (int other = 0; other < static_cast<int>(column_of_row.size()); ++other)
      cost += std::abs(problem.source_distances(row, other) -
                       problem.target_distances(column_of_row[row], column_of_row[other]));
  }
  return cost;
}

/// The costs of all injections of the rows into the columns, in ascending order.
std::vector<float> all_costs(const PatchProblem& problem) {
  const int rows = static_cast<int>(problem.list_distortion.rows());
  std::vector<int> columns(problem.list_distortion.cols());
  std::iota(columns.begin(), columns.end(), 0);
  std::set<std::vector<int>> injections;
  do {
    injections.insert({columns.begin(), columns.begin() + rows});
  } while (std::next_permutation(columns.begin(), columns.end()));
  std::vector<float> costs;
  for (const auto& injection : injections) costs.push_back(plain_cost(problem, injection));
  std::sort(costs.begin(), costs.end());
  return costs;
}

bool is_injection(const std::vector<int>& column_of_row, int columns) {
  const std::set<int> distinct(column_of_row.begin(), column_of_row.end());
  return distinct.size() == column_of_row.size() && *distinct.begin() >= 0 &&
         *distinct.rbegin() < columns;
}

/// That these are matchings of different costs as stated, in order, the best that there are.
void expect_best(const PatchProblem& problem, const std::vector<OneToOneMatching>& found,
                 int count) {
  const std::vector<float> costs = all_costs(problem);
  ASSERT_EQ(found.size(), std::min<std::size_t>(count, costs.size()));
  std::set<std::vector<int>> distinct;
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].column_of_row.size(), problem.list_distortion.rows());
    EXPECT_TRUE(
        is_injection(found[i].column_of_row, static_cast<int>(problem.list_distortion.cols())));
    EXPECT_TRUE(distinct.insert(found[i].column_of_row).second);
    EXPECT_NEAR(found[i].cost, plain_cost(problem, found[i].column_of_row), kRounding);
    EXPECT_NEAR(found[i].cost, costs[i], kRounding);
  }
  EXPECT_TRUE(std::ranges::is_sorted(found, {}, &OneToOneMatching::cost));
}

TEST(LeastDistortionMatchings, AreTheBestOfAllInjections) {
  test::Random random(1);
  for (int rows = 1; rows <= 6; ++rows) {
    for (int columns = rows; columns <= 7; ++columns) {
      const PatchProblem problem = random_problem(rows, columns, random);
      for (const int count : {1, 8}) {
        SCOPED_TRACE(testing::Message() << rows << " x " << columns << ", best " << count);
        expect_best(problem, least_distortion_matchings(problem, count), count);
        const PatchProblem tied = with_ties(problem);
        expect_best(tied, least_distortion_matchings(tied, count), count);
      }
    }
  }
}

TEST(LeastDistortionMatchings, AreAllIfMoreAreWanted) {
  test::Random random(2);
  const PatchProblem problem = random_problem(3, 4, random);
  const auto found = least_distortion_matchings(problem, 1000);
  EXPECT_EQ(found.size(), 24);
  expect_best(problem, found, 1000);
}

TEST(LeastDistortionMatchings, GiveTiesToTheLowerColumns) {
  const PatchProblem equal{Eigen::MatrixXf::Zero(3, 3), Eigen::MatrixXf::Zero(4, 4),
                           Eigen::MatrixXf::Constant(3, 4, 0.5f)};
  const auto found = least_distortion_matchings(equal, 3);
  ASSERT_EQ(found.size(), 3);
  EXPECT_EQ(found[0].column_of_row, (std::vector{0, 1, 2}));
  EXPECT_EQ(found[1].column_of_row, (std::vector{0, 1, 3}));
  EXPECT_EQ(found[2].column_of_row, (std::vector{0, 2, 1}));
}

TEST(LeastDistortionMatchings, FindTheRelabellingOfAPatch) {
  test::Random random(3);
  const Eigen::MatrixXf distances = random_distances(8, random);
  const std::vector<int> columns = random.permutation(8);
  PatchProblem problem{distances, distances, Eigen::MatrixXf::Zero(8, 8)};
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < 8; ++b) problem.target_distances(columns[a], columns[b]) = distances(a, b);
  }
  const auto found = least_distortion_matchings(problem, 2);
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found[0].column_of_row, columns);
  EXPECT_EQ(found[0].cost, 0);
  EXPECT_GT(found[1].cost, 0);
}

TEST(LeastDistortionMatchings, StayValidWhenTheSearchIsCut) {
  test::Random random(4);
  for (int problem_number = 0; problem_number < 20; ++problem_number) {
    const PatchProblem problem = random_problem(7, 8, random);
    const float least = least_distortion_matchings(problem, 1).front().cost;
    float previous = std::numeric_limits<float>::infinity();
    for (const int nodes : {1, 10, 100, 1000, 100000}) {
      const auto found = least_distortion_matchings(problem, 5, {.max_search_nodes = nodes});
      ASSERT_FALSE(found.empty());
      for (const OneToOneMatching& matching : found) {
        EXPECT_TRUE(is_injection(matching.column_of_row, 8));
        EXPECT_NEAR(matching.cost, plain_cost(problem, matching.column_of_row), kRounding);
      }
      EXPECT_LE(found.front().cost, previous);
      EXPECT_GE(found.front().cost, least - kRounding);
      previous = found.front().cost;
    }
    EXPECT_NEAR(previous, least, kRounding);
  }
}

TEST(LeastDistortionMatchings, NeedAsManyColumnsAsRows) {
  test::Random random(5);
  EXPECT_THROW(least_distortion_matchings(random_problem(4, 3, random), 1), InvalidInput);
}

/// Distortion of a pair against the list and the one-to-one `core`, as residual matches are judged.
float plain_pair_cost(const PatchProblem& problem, const Correspondence& core, const Match& pair) {
  float cost = problem.list_distortion(pair.source, pair.target);
  for (const Match& match : core)
    cost += std::abs(problem.source_distances(pair.source, match.source) -
                     problem.target_distances(pair.target, match.target));
  return cost;
}

PatchProblem transposed(const PatchProblem& problem) {
  return {problem.target_distances, problem.source_distances, problem.list_distortion.transpose()};
}

Correspondence transposed(Correspondence matches) {
  for (Match& match : matches) std::swap(match.source, match.target);
  std::sort(matches.begin(), matches.end());
  return matches;
}

/// The least distorted matching of no more rows than columns and for every column left over the row
/// of least distortion.
Correspondence plainly_matched(const PatchProblem& problem) {
  Correspondence core;
  std::set<int> matched;
  const auto best = least_distortion_matchings(problem, 1).front().column_of_row;
  for (int row = 0; row < static_cast<int>(best.size()); ++row) {
    core.push_back({row, best[row]});
    matched.insert(best[row]);
  }
  Correspondence result = core;
  for (int column = 0; column < problem.list_distortion.cols(); ++column) {
    if (matched.contains(column)) continue;
    Match residual{0, column};
    for (int row = 1; row < static_cast<int>(best.size()); ++row) {
      if (plain_pair_cost(problem, core, {row, column}) < plain_pair_cost(problem, core, residual))
        residual.source = row;
    }
    result.push_back(residual);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(MatchPatch, AddsTheLeastDistortedResidualMatches) {
  test::Random random(6);
  for (int rows = 1; rows <= 5; ++rows) {
    for (int columns = rows; columns <= 8; ++columns) {
      SCOPED_TRACE(testing::Message() << rows << " x " << columns);
      const PatchProblem problem = random_problem(rows, columns, random);
      const Correspondence expected = plainly_matched(problem);
      EXPECT_EQ(match_patch(problem), expected);
      EXPECT_EQ(match_patch(transposed(problem)), transposed(expected));
    }
  }
}

void expect_covering(const Correspondence& matches, int rows, int columns) {
  std::set<int> sources, targets;
  for (const Match& match : matches) {
    sources.insert(match.source);
    targets.insert(match.target);
  }
  EXPECT_EQ(sources.size(), rows);
  EXPECT_EQ(targets.size(), columns);
  EXPECT_TRUE(std::ranges::is_sorted(matches));
  EXPECT_EQ(std::ranges::adjacent_find(matches), matches.end());
}

TEST(MatchPatch, CoversEveryRowAndColumnOfPatchesOfAnySize) {
  test::Random random(7);
  for (const auto& [rows, columns] : std::vector<std::pair<int, int>>{
           {1, 1}, {1, 9}, {9, 1}, {6, 6}, {8, 8}, {9, 9}, {3, 20}, {20, 3}, {12, 15}, {15, 12}}) {
    SCOPED_TRACE(testing::Message() << rows << " x " << columns);
    const PatchProblem problem = random_problem(rows, columns, random);
    for (const int max_bases : {1, 4, 8}) {
      const auto matchings = match_patch(problem, 3, {.max_patch_bases = max_bases});
      ASSERT_FALSE(matchings.empty());
      for (const Correspondence& matches : matchings) expect_covering(matches, rows, columns);
    }
  }
}

TEST(MatchPatch, SearchesAmongTheFirstBasesOnly) {
  test::Random random(8);
  const PatchProblem problem = random_problem(10, 11, random);
  PatchProblem core{problem.source_distances.topLeftCorner(5, 5),
                    problem.target_distances.topLeftCorner(5, 5),
                    problem.list_distortion.topLeftCorner(5, 5)};
  const Correspondence best = match_patch(core);
  ASSERT_EQ(best.size(), 5);
  const Correspondence matches = match_patch(problem, {.max_patch_bases = 5});
  EXPECT_TRUE(std::ranges::includes(matches, best));
  // What is left over has one match each, unless both ends chose each other.
  EXPECT_LE(matches.size(), 5 + 5 + 6);
}

TEST(MatchPatch, GivesTheBestFirst) {
  test::Random random(9);
  const PatchProblem problem = random_problem(5, 5, random);
  const auto best = least_distortion_matchings(problem, 4);
  const auto matchings = match_patch(problem, 4);
  ASSERT_EQ(matchings.size(), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(matchings[i], to_correspondence(best[i].column_of_row));
  EXPECT_EQ(match_patch(problem), matchings.front());
}

TEST(MatchPatch, IsEmptyWithoutRowsOrColumns) {
  test::Random random(10);
  for (const auto& [rows, columns] : std::vector<std::pair<int, int>>{{0, 0}, {0, 4}, {4, 0}}) {
    EXPECT_TRUE(match_patch(random_problem(rows, columns, random)).empty());
    EXPECT_TRUE(match_patch(random_problem(rows, columns, random), 3).empty());
  }
}

TEST(PatchMatchingOptions, AreChecked) {
  EXPECT_NO_THROW(PatchMatchingOptions{}.validate());
  EXPECT_THROW(PatchMatchingOptions{.max_patch_bases = 0}.validate(), InvalidInput);
  EXPECT_THROW(PatchMatchingOptions{.max_patch_bases = 13}.validate(), InvalidInput);
  EXPECT_THROW(PatchMatchingOptions{.max_search_nodes = 0}.validate(), InvalidInput);
}

}  // namespace
}  // namespace isomatch
