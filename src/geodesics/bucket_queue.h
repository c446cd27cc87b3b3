// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace isomatch {

/// A monotone priority queue of vertices for Dijkstra's algorithm. Entries come out bucket by
/// bucket; within one bucket first those that were there when it was opened, in the order they went
/// in, then those that came later, in the order of their keys. So a vertex may come out before its
/// key is final, but not often, and at most once a bucket: where edges are shorter than a bucket
/// the queue is a heap. A vertex whose key falls is pushed again; its old entry is the caller's to
/// skip.
class BucketQueue {
 public:
  struct Entry {
    float key;
    int vertex;
  };

  /// `width` is that of a bucket, positive.
  explicit BucketQueue(float width) : inverse_width_(1 / width) {}

  /// `key` must not be below the key that was popped last.
  void push(float key, int vertex) {
    const float slot = (key - base_) * inverse_width_;
    if (!(slot < kBuckets)) {
      far_.push_back({key, vertex});
    } else if (const int bucket = static_cast<int>(slot); bucket != current_) {
      buckets_[bucket].push_back({key, vertex});
      ++pending_;
    } else {
      late_.push_back({key, vertex});
      std::ranges::push_heap(late_, std::greater(), &Entry::key);
    }
  }

  /// Takes out the next entry; false and ready for another search if there is none.
  bool pop(Entry& entry) {
    while (next_ == buckets_[current_].size()) {
      if (!late_.empty()) return pop_late(entry);
      if (!advance()) return false;
    }
    entry = buckets_[current_][next_++];
    --pending_;
    return true;
  }

  /// The entry after the one that was popped last, or null if that is not known yet.
  const Entry* peek() const {
    return next_ < buckets_[current_].size() ? &buckets_[current_][next_] : nullptr;
  }

 private:
  /// Buckets that are open at a time: 64 mean edge lengths, more than most arcs.
  static constexpr int kBuckets = 256;

  bool pop_late(Entry& entry) {
    std::ranges::pop_heap(late_, std::greater(), &Entry::key);
    entry = late_.back();
    late_.pop_back();
    return true;
  }

  bool advance() {
    buckets_[current_].clear();
    next_ = 0;
    if (pending_ > 0) {
      ++current_;
      return true;
    }
    current_ = 0;
    base_ = 0;
    if (far_.empty()) return false;
    open_far_buckets();
    return true;
  }

  void open_far_buckets() {
    base_ = std::ranges::min(far_, {}, &Entry::key).key;
    std::swap(far_, scratch_);
    current_ = -1;  // None of these is late.
    for (const Entry& entry : scratch_) push(entry.key, entry.vertex);
    current_ = 0;
    scratch_.clear();
  }

  float inverse_width_;
  float base_ = 0;           ///< Where the first bucket starts.
  int current_ = 0;          ///< The bucket that is being emptied.
  std::size_t next_ = 0;     ///< Its first entry that was not popped.
  std::size_t pending_ = 0;  ///< Entries in buckets from the current one on that were not popped.
  std::array<std::vector<Entry>, kBuckets> buckets_;
  std::vector<Entry> late_;  ///< A heap: entries for the current bucket since it was opened.
  std::vector<Entry> far_;   ///< Entries beyond the last bucket.
  std::vector<Entry> scratch_;
};

}  // namespace isomatch
