// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace isomatch {

/// Values that are made when they are first asked for, by key, and kept. Safe to share by threads:
/// who asks for what another one is making waits for it. If making throws, it is not made, and
/// tried again the next time. What is made must not ask for itself.
template <class Key, class Value>
class Memo {
 public:
  /// `make()` returns a `Value`.
  template <class Make>
  std::shared_ptr<const Value> get(const Key& key, const Make& make) {
    Entry& entry = find(key);
    const std::lock_guard lock(entry.making);
    if (!entry.value) entry.value = std::make_shared<const Value>(make());
    return entry.value;
  }

 private:
  struct Entry {
    Key key;
    std::mutex making;
    std::shared_ptr<const Value> value;
  };

  Entry& find(const Key& key) {
    const std::lock_guard lock(finding_);
    for (const auto& entry : entries_)
      if (entry->key == key) return *entry;
    entries_.push_back(std::make_unique<Entry>());
    entries_.back()->key = key;
    return *entries_.back();
  }

  std::mutex finding_;
  std::vector<std::unique_ptr<Entry>> entries_;
};

}  // namespace isomatch
