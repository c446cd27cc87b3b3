// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <string>

namespace isomatch::results {

/// Where the results of the pairs of a batch go. Those of a pair appear whole or not at all. Safe
/// to use from several threads, of which each has other pairs.
class ResultStore {
 public:
  virtual ~ResultStore() = default;

  /// The folder in which this process makes the results of a pair.
  virtual std::string place_for(const std::string& pair) const = 0;
  /// Moves them into place, as they are there. False, and they are removed, if another process has
  /// been faster. Throws `BadFile`.
  virtual bool finish(const std::string& pair) = 0;
  /// Removes them, as far as that can be done.
  virtual void abandon(const std::string& pair) noexcept = 0;
};

/// Each pair's are a folder of its name in `folder`.
std::unique_ptr<ResultStore> folder_store(const std::string& folder);

/// All are in one SQLite Archive, as files NAME/file. They are made in a folder for temporary
/// files. Throws `BadFile` as `SqlArchive`, and if there can be no such folder.
std::unique_ptr<ResultStore> archive_store(const std::string& archive);

}  // namespace isomatch::results
