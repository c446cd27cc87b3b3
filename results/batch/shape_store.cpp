// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/shape_store.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "results/loaded_mesh.h"

namespace isomatch::results {
namespace {

std::string key_of(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  return error ? path : real.string();
}

}  // namespace

MatchInput ShapeStore::get(const std::string& path) {
  const std::shared_ptr<Entry> entry = entry_of(key_of(path));
  const std::scoped_lock lock(entry->reading);
  if (!entry->input) {
    MeshReadReport report;
    Mesh mesh = read_mesh(path, &report);
    Shape shape = shape_of(path, std::move(mesh));
    entry->input = std::make_shared<const MatchInput>(path, std::move(report), std::move(shape));
    account(entry, kept_bytes(entry->input->mesh().num_vertices()));
  }
  MatchInput input = *entry->input;
  input.path = path;
  return input;
}

int ShapeStore::reads() const {
  const std::scoped_lock lock(mutex_);
  return reads_;
}

std::shared_ptr<ShapeStore::Entry> ShapeStore::entry_of(const std::string& key) {
  const std::scoped_lock lock(mutex_);
  const auto known = std::ranges::find(
      entries_, key, [](const auto& entry) -> auto& { return entry->key; });
  if (known != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, known);
  } else {
    entries_.push_front(std::make_shared<Entry>());
    entries_.front()->key = key;
  }
  return entries_.front();
}

/// Adds a shape to what is held, and lets others go for it.
void ShapeStore::account(const std::shared_ptr<Entry>& entry, std::uint64_t bytes) {
  const std::scoped_lock lock(mutex_);
  ++reads_;
  entry->bytes = bytes;
  held_ += bytes;
  for (auto last = entries_.end(); held_ > most_ && last != entries_.begin();) {
    --last;
    if (*last == entry || (*last)->bytes == 0) continue;
    held_ -= (*last)->bytes;
    last = entries_.erase(last);
  }
}

}  // namespace isomatch::results
