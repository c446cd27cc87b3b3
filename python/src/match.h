// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <string>
#include <vector>

#include "isomatch/stage_times.h"
#include "results/folder/inputs.h"
#include "results/folder/report.h"
#include "results/json.h"
#include "results/option_names.h"
#include "results/page/shown_match.h"
#include "run.h"

/// What the results of both methods share.
namespace isomatch::python {

/// How a result is saved.
struct SavedAs {
  /// Where, and where it finds its meshes and landmarks; empty for no landmarks.
  std::string folder, source, target, landmarks;
  /// Of these, what is in the folder because it was given as arrays.
  std::vector<std::string> arrays;
  bool target_to_source = false, page = false;
};

/// What saving may write, `files` of the method besides the arrays and the page.
results::ResultPlan make_plan(const SavedAs& saved, std::vector<std::string> files);

/// Fails now rather than after the arrays were written, if saving would.
void check_save(const SavedAs& saved, std::vector<std::string> files);

/// Options of a run as they go into its report.
template <class Options>
results::Json report_options(const std::string& method, const Options& options) {
  results::Json json = results::options_json(method);
  results::add_options(json, options);
  return json;
}

/// Adds flags for `options` that differ from `defaults` to a command line.
void add_flags(std::vector<std::string>& words, const results::Json& options,
               const results::Json& defaults);

/// The command line that makes what is saved: flags for `options` that differ from `defaults`.
std::vector<std::string> command_line(const SavedAs& saved, const results::Json& options,
                                      const results::Json& defaults);

/// `inputs` under the names of `saved`.
void rename(results::MatchInputs& inputs, const SavedAs& saved, std::vector<std::string> words);

/// Writes the page of a result that was saved: of what `shown()`, a `ShownMatch`, shows.
void save_page(const SavedAs& saved, const std::function<results::ShownMatch()>& shown,
               const RunOptions& how);

/// Seconds by stage.
pybind11::dict to_dict(const std::vector<StageTime>& times);

/// Fields under their names.
pybind11::dict to_dict(const Fit& fit);

}  // namespace isomatch::python
