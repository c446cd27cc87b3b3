// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "isomatch/stage_times.h"
#include "json.h"
#include "match/inputs.h"
#include "match/option_names.h"
#include "match/report.h"

/// What the results of both methods share.
namespace isomatch::python {

/// Where a saved result finds its meshes.
struct SavedAs {
  std::string folder, source, target;
};

/// Options of a run as they go into its report.
template <class Options>
cli::Json report_options(const std::string& method, const Options& options) {
  cli::Json json = cli::options_json(method, 0);
  cli::add_options(json, options);
  return json;
}

/// The command line that makes what is saved: flags for `options` that differ from `defaults`.
std::vector<std::string> command_line(const SavedAs& saved, const cli::Json& options,
                                      const cli::Json& defaults);

/// `inputs` under the names of `saved`.
void rename(cli::MatchInputs& inputs, const SavedAs& saved, std::vector<std::string> words);

/// Seconds by stage.
pybind11::dict to_dict(const std::vector<StageTime>& times);

}  // namespace isomatch::python
