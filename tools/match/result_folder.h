// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "json.h"

namespace isomatch::cli {

/// The folder that a match leaves behind, whatever the method. Each file appears whole or not at
/// all; everything throws `BadFile`.
class ResultFolder {
 public:
  /// Creates the folder if need be. Removes every file that an earlier match may have left in it,
  /// by name, so that the results are all of one run; other files stay.
  explicit ResultFolder(const std::string& path);

  /// The path of a file of results, whose name may contain folders; they are created.
  std::string add(const std::string& name);
  /// Writes the report with the list of `files`. It comes last and tells that the results are
  /// complete.
  void write_report(Json report);
  void write_json(const std::string& name, const Json& json);

 private:
  std::filesystem::path path_;
  std::vector<std::string> files_;
};

}  // namespace isomatch::cli
