// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace isomatch {

/// Sorts the items that `generate(sink)` hands to its `sink(bucket, item)`, first by bucket (0 up
/// to `num_buckets`), then by `operator<`. `generate` is called twice and must repeat itself. O(N)
/// while buckets stay small, which makes it several times faster than std::sort on the edges of a
/// mesh.
template <class Item, class Generate>
std::vector<Item> bucket_sorted(int num_buckets, const Generate& generate) {
  std::vector<int> offsets(num_buckets + 1, 0);
  generate([&](int bucket, const Item&) { ++offsets[bucket + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<Item> items(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  generate([&](int bucket, const Item& item) { items[next[bucket]++] = item; });
  for (int bucket = 0; bucket < num_buckets; ++bucket)
    std::sort(items.begin() + offsets[bucket], items.begin() + offsets[bucket + 1]);
  return items;
}

}  // namespace isomatch
