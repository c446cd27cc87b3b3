// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/patch_matching.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "isomatch/error.h"

namespace isomatch {
namespace {

/// Depth-first search over the columns of one row after the other; keeps the best few.
class BranchAndBound {
 public:
  BranchAndBound(const PatchProblem& problem, int count, int max_nodes)
      : problem_(problem),
        count_(count),
        rows_(static_cast<int>(problem.list_distortion.rows())),
        columns_(static_cast<int>(problem.list_distortion.cols())),
        nodes_left_(max_nodes),
        column_of_row_(rows_, -1),
        column_used_(columns_, false),
        rest_bound_(rows_ + 1, 0.f) {
    for (int row = rows_ - 1; row >= 0; --row)
      rest_bound_[row] = rest_bound_[row + 1] + problem.list_distortion.row(row).minCoeff();
  }

  std::vector<OneToOneMatching> run() {
    descend(0, 0);
    return std::move(best_);
  }

 private:
  void descend(int row, float cost) {
    if (row == rows_) return keep({cost, column_of_row_});
    for (const auto& [increment, column] : branches(row)) {
      if (cost + increment + rest_bound_[row + 1] >= worst_kept()) break;
      if (!best_.empty() && nodes_left_-- <= 0) break;
      column_of_row_[row] = column;
      column_used_[column] = true;
      descend(row + 1, cost + increment);
      column_used_[column] = false;
    }
  }

  float worst_kept() const {
    return static_cast<int>(best_.size()) < count_ ? std::numeric_limits<float>::infinity()
                                                   : best_.back().cost;
  }

  void keep(OneToOneMatching matching) {
    const auto place = std::ranges::upper_bound(best_, matching.cost, {}, &OneToOneMatching::cost);
    best_.insert(place, std::move(matching));
    if (static_cast<int>(best_.size()) > count_) best_.pop_back();
  }

  /// The free columns for `row` with the cost that each adds, cheapest first.
  std::vector<std::pair<float, int>> branches(int row) const {
    std::vector<std::pair<float, int>> result;
    for (int column = 0; column < columns_; ++column) {
      if (column_used_[column]) continue;
      float increment = problem_.list_distortion(row, column);
      for (int other = 0; other < row; ++other) increment += 2 * pair_cost(row, column, other);
      result.emplace_back(increment, column);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  float pair_cost(int row, int column, int other) const {
    return std::abs(problem_.source_distances(row, other) -
                    problem_.target_distances(column, column_of_row_[other]));
  }

  const PatchProblem& problem_;
  int count_;
  int rows_, columns_;
  int nodes_left_;
  std::vector<int> column_of_row_;
  std::vector<bool> column_used_;
  std::vector<float> rest_bound_;
  std::vector<OneToOneMatching> best_;
};

PatchProblem transposed(const PatchProblem& problem) {
  return {problem.target_distances, problem.source_distances, problem.list_distortion.transpose()};
}

PatchProblem first_bases(const PatchProblem& problem, int count) {
  const Eigen::Index rows = std::min<Eigen::Index>(count, problem.list_distortion.rows());
  const Eigen::Index columns = std::min<Eigen::Index>(count, problem.list_distortion.cols());
  return {problem.source_distances.topLeftCorner(rows, rows),
          problem.target_distances.topLeftCorner(columns, columns),
          problem.list_distortion.topLeftCorner(rows, columns)};
}

/// Sum of distortions of the pair (row, column) against the list and the matching found.
float pair_distortion(const PatchProblem& problem, const Correspondence& matching, int row,
                      int column) {
  float sum = problem.list_distortion(row, column);
  for (const Match& match : matching)
    sum += std::abs(problem.source_distances(row, match.source) -
                    problem.target_distances(column, match.target));
  return sum;
}

/// `matching` with a residual match for each row and column that it leaves out.
Correspondence with_residual_matches(const PatchProblem& problem, const Correspondence& matching) {
  const int rows = static_cast<int>(problem.list_distortion.rows());
  const int columns = static_cast<int>(problem.list_distortion.cols());
  Eigen::MatrixXf sums(rows, columns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      sums(row, column) = pair_distortion(problem, matching, row, column);
  }
  std::vector<bool> row_matched(rows, false), column_matched(columns, false);
  for (const Match& match : matching)
    row_matched[match.source] = column_matched[match.target] = true;
  Correspondence result = matching;
  Eigen::Index best;
  for (int row = 0; row < rows; ++row) {
    if (row_matched[row]) continue;
    sums.row(row).minCoeff(&best);
    result.push_back({row, static_cast<int>(best)});
  }
  for (int column = 0; column < columns; ++column) {
    if (column_matched[column]) continue;
    sums.col(column).minCoeff(&best);
    result.push_back({static_cast<int>(best), column});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

void PatchMatchingOptions::validate() const {
  if (max_patch_bases < 1 || max_patch_bases > 12)
    throw InvalidInput("max_patch_bases must be in [1, 12]");
  if (max_search_nodes < 1) throw InvalidInput("max_search_nodes must be at least 1");
}

std::vector<OneToOneMatching> least_distortion_matchings(const PatchProblem& problem, int count,
                                                         const PatchMatchingOptions& options) {
  if (problem.list_distortion.rows() > problem.list_distortion.cols())
    throw InvalidInput("a one-to-one matching needs at least as many columns as rows");
  return BranchAndBound(problem, count, options.max_search_nodes).run();
}

std::vector<Correspondence> match_patch(const PatchProblem& problem, int count,
                                        const PatchMatchingOptions& options) {
  if (problem.list_distortion.size() == 0) return {};
  const PatchProblem core = first_bases(problem, options.max_patch_bases);
  const bool swapped = core.list_distortion.rows() > core.list_distortion.cols();
  std::vector<Correspondence> results;
  for (const OneToOneMatching& found :
       least_distortion_matchings(swapped ? transposed(core) : core, count, options)) {
    Correspondence matching;
    for (int row = 0; row < static_cast<int>(found.column_of_row.size()); ++row) {
      const int column = found.column_of_row[row];
      matching.push_back(swapped ? Match{column, row} : Match{row, column});
    }
    results.push_back(with_residual_matches(problem, matching));
  }
  return results;
}

Correspondence match_patch(const PatchProblem& problem, const PatchMatchingOptions& options) {
  std::vector<Correspondence> matchings = match_patch(problem, 1, options);
  return matchings.empty() ? Correspondence{} : std::move(matchings.front());
}

}  // namespace isomatch
