// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstddef>
#include <vector>

#include "results/batch/pair_list.h"

/// In which order pairs are matched, and by which process, so that shapes are used again soon.
namespace isomatch::results {

/// One of `count` shares, from 1, that together are all pairs, in the order of the list. Their
/// sizes differ by one at most. A share is a block of the table of all shapes by all shapes, as far
/// as the pairs fill it: of every pair of many shapes, a share of n needs less than 2 sqrt(n)
/// shapes, where a run of neighbours in the list needs nearly all. The least that is possible is
/// sqrt(n).
std::vector<ListedPair> share_of(const std::vector<ListedPair>& pairs, int share, int count);

/// The places of the pairs in an order in which pairs of the same few shapes follow each other,
/// however few they are: blocks, made of smaller blocks, and so on. O(n log n).
std::vector<std::size_t> order_of_work(const std::vector<ListedPair>& pairs);

}  // namespace isomatch::results
