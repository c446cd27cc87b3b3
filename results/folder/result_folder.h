// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/files/input_files.h"
#include "results/files/written_files.h"
#include "results/json.h"

namespace isomatch::results {

/// Which files results consist of, seen from their folder.
struct ResultPlan {
  std::string folder;
  /// All that may be written, but for report.json.
  std::vector<std::string> files;
  /// What must stay as it is.
  InputFiles inputs;
  /// Those of `files` that are there already when the results are written.
  std::vector<std::string> ready = {};
};

/// Throws `BadFile` unless the folder can be written, nothing stands in the way of the plan but
/// files of earlier runs (see `written_files`), and none of these is an input. Leaves no trace.
void check_plan(const ResultPlan& plan);

/// The folder that a match leaves behind, whatever the method. Each file appears whole or not at
/// all; everything throws `BadFile`.
class ResultFolder {
 public:
  /// Checks the plan once more and creates the folder if need be. Removes what earlier runs wrote,
  /// so that the results are all of one run; other files stay.
  explicit ResultFolder(const ResultPlan& plan);

  /// The path of a file of results, whose name may contain folders; they are created. One of the
  /// plan.
  std::string add(const std::string& name);
  /// Writes the report with the list of files. It comes last and tells that the results are
  /// complete.
  /// Returns it with the list.
  Json write_report(Json report);
  void write_json(const std::string& name, const Json& json);

 private:
  std::filesystem::path path_;
  std::vector<std::string> files_;
};

}  // namespace isomatch::results
