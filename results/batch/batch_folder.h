// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results/batch/pair_list.h"
#include "results/json.h"

namespace isomatch::results {

/// The folder of a batch. A pair's results are a folder in it that appears whole or not at all, so
/// a batch that was killed can go on where it was. Several processes may work in it.
class BatchFolder {
 public:
  /// Takes the folder, in which a batch of the same version and `options` must have begun. Throws
  /// `BadFile` where that is not so.
  BatchFolder(const std::string& path, const Json& options);
  /// The same, but makes the folder if there is no batch in it, and goes on with one only if
  /// `go_on`. Removes what processes of this machine that are gone left unfinished. Throws as well
  /// where one of `files`, which are going to be written, is there without a batch.
  static BatchFolder begun(const std::string& path, const Json& options,
                           const std::vector<std::string>& files, bool go_on);

  /// The report of a pair that is finished. Throws `BadFile` if what is there is no whole result of
  /// this batch and of these files.
  std::optional<Json> report_of(const ListedPair& pair) const;
  /// Where this process makes the results of a pair; nothing is there.
  std::string place_for(const std::string& pair) const;
  /// Moves them into place. False, and they are removed, if another process has been faster.
  bool finish(const std::string& pair) const;
  /// Removes them, as far as that can be done.
  void abandon(const std::string& pair) const noexcept;

  /// Of a file in it.
  std::string path_of(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
  Json options_;
};

}  // namespace isomatch::results
