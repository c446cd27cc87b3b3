// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "results/folder/inputs.h"

namespace isomatch::results {

/// Shapes that were read from files, kept with all that matching prepared of them, so that a shape
/// of many pairs is read and prepared once. When they would take more memory than is allowed, those
/// that were not asked for the longest are let go. Safe to use from several threads, of which one
/// waits while another one reads the same file.
class ShapeStore {
 public:
  /// Keeps about `bytes` at most, besides what is in use.
  explicit ShapeStore(std::uint64_t bytes) : most_(bytes) {}

  /// Throws `BadFile` if the file cannot be read, each time it is asked for.
  MatchInput get(const std::string& path);

  /// Files that were read, for each time.
  int reads() const;

 private:
  struct Entry {
    std::string key;
    std::mutex reading;
    std::shared_ptr<const MatchInput> input;
    std::uint64_t bytes = 0;
  };
  using Entries = std::list<std::shared_ptr<Entry>>;

  std::shared_ptr<Entry> entry_of(const std::string& key);
  void account(const std::shared_ptr<Entry>& entry, std::uint64_t bytes);

  const std::uint64_t most_;
  mutable std::mutex mutex_;
  Entries entries_;  ///< The one that was asked for last comes first.
  std::uint64_t held_ = 0;
  int reads_ = 0;
};

}  // namespace isomatch::results
