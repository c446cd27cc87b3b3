// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/shares.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace isomatch::results {
namespace {

/// Pairs as points of a table, which is cut in two again and again.
class Blocks {
 public:
  /// `shares` are cut out first.
  Blocks(const std::vector<ListedPair>& pairs, std::size_t shares)
      : shares_(shares), order_(pairs.size()) {
    std::unordered_map<std::string, int> numbers;
    const auto number_of = [&](const std::string& shape) {
      return numbers.emplace(shape, static_cast<int>(numbers.size())).first->second;
    };
    for (const ListedPair& pair : pairs) {
      const int source = number_of(pair.source), target = number_of(pair.target);
      // Both directions are the same point: they need the same shapes.
      cells_.push_back({std::min(source, target), std::max(source, target)});
    }
    seen_.resize(numbers.size());
    std::iota(order_.begin(), order_.end(), 0);
    cut({0, order_.size()}, {0, shares});
  }

  std::size_t begin_of(std::size_t share) const { return order_.size() * share / shares_; }
  const std::vector<std::size_t>& order() const { return order_; }

 private:
  struct Cell {
    int lower, upper;
  };
  struct Range {
    std::size_t begin, end;
    std::size_t size() const { return end - begin; }
    std::size_t middle() const { return begin + size() / 2; }
  };

  void cut(Range part, Range shares) {
    if (part.size() < 2) return;
    const bool between_shares = shares.size() > 1;
    const std::size_t middle = between_shares ? begin_of(shares.middle()) : part.middle();
    // The longer side, so that what comes of it is nearly square.
    const bool across = distinct(part, &Cell::lower) < distinct(part, &Cell::upper);
    const auto key = [&](std::size_t pair) {
      const auto [lower, upper] = cells_[pair];
      return across ? std::tuple(upper, lower, pair) : std::tuple(lower, upper, pair);
    };
    const auto at = [&](std::size_t place) {
      return order_.begin() + static_cast<std::ptrdiff_t>(place);
    };
    std::nth_element(at(part.begin), at(middle), at(part.end),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    cut({part.begin, middle}, between_shares ? Range{shares.begin, shares.middle()} : shares);
    cut({middle, part.end}, between_shares ? Range{shares.middle(), shares.end} : shares);
  }

  /// How many shapes there are in a part, on one side of the table.
  int distinct(Range part, int Cell::*side) {
    ++question_;
    int count = 0;
    for (std::size_t place = part.begin; place < part.end; ++place)
      if (std::exchange(seen_[static_cast<std::size_t>(cells_[order_[place]].*side)], question_) !=
          question_)
        ++count;
    return count;
  }

  std::size_t shares_;
  std::vector<std::size_t> order_;
  std::vector<Cell> cells_;
  /// Of each shape, the last question in which it was seen.
  std::vector<std::size_t> seen_;
  std::size_t question_ = 0;
};

}  // namespace

std::vector<ListedPair> share_of(const std::vector<ListedPair>& pairs, int share, int count) {
  const Blocks blocks(pairs, static_cast<std::size_t>(count));
  const auto number = static_cast<std::size_t>(share);
  const auto at = [&](std::size_t place) {
    return blocks.order().begin() + static_cast<std::ptrdiff_t>(place);
  };
  std::vector<std::size_t> places(at(blocks.begin_of(number - 1)), at(blocks.begin_of(number)));
  std::ranges::sort(places);
  std::vector<ListedPair> some;
  some.reserve(places.size());
  for (const std::size_t place : places) some.push_back(pairs[place]);
  return some;
}

std::vector<std::size_t> order_of_work(const std::vector<ListedPair>& pairs) {
  return Blocks(pairs, 1).order();
}

}  // namespace isomatch::results
