// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "results/json.h"

namespace isomatch::results {

/// The folder of a batch. A pair's results are a folder in it that appears whole or not at all, so
/// a batch that was killed can go on where it was.
class BatchFolder {
 public:
  /// Makes the folder, or takes one in which a batch of the same version and `options` has begun,
  /// which needs `go_on`. Throws `BadFile` where that is not so, or the folder cannot be written.
  BatchFolder(const std::string& path, const Json& options, bool go_on);

  /// The report of a pair that is finished.
  std::optional<Json> report_of(const std::string& pair) const;
  /// Where the results of a pair are made, an empty folder: what an earlier run left there is
  /// removed.
  std::string begin(const std::string& pair) const;
  /// Moves them into place.
  void finish(const std::string& pair) const;
  /// Removes them.
  void abandon(const std::string& pair) const;

  /// Of a file in it.
  std::string path_of(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path unfinished(const std::string& pair) const;

  std::filesystem::path path_;
};

}  // namespace isomatch::results
