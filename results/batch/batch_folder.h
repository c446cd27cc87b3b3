// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/batch/pair_list.h"
#include "results/json.h"

namespace isomatch::results {

/// Whether a file of a batch's folder is an archive of results: results*.sqlar.
bool is_archive_name(const std::string& name);

/// The folder of a batch, and what is finished in it: a pair's results are a folder, or files in an
/// archive, whatever `ResultStore` has made them. Several processes may work in it.
class BatchFolder {
 public:
  /// Takes the folder, in which a batch of the same version and `options` must have begun, and
  /// looks at its archives. Throws `BadFile` where there is none, or where an archive cannot be
  /// read.
  BatchFolder(const std::string& path, const Json& options);
  /// The same, but makes the folder if there is no batch in it, and goes on with one only if
  /// `go_on`. Removes what processes of this machine that are gone left unfinished. Throws as well
  /// where one of `files`, which are going to be written, is there without a batch.
  static BatchFolder begun(const std::string& path, const Json& options,
                           const std::vector<std::string>& files, bool go_on);

  /// The report of a pair that is finished; in an archive, when the folder was taken. Throws
  /// `BadFile` if what is there is no whole result of this batch and of these files.
  std::optional<Json> report_of(const ListedPair& pair) const;
  /// The same folder as it is now.
  BatchFolder again() const { return {path_.string(), options_}; }

  /// Of a file in it.
  std::string path_of(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
  Json options_;
  /// Pairs in archives, and which archive it is.
  std::map<std::string, std::filesystem::path> packed_;
};

}  // namespace isomatch::results
