// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match.h"

#include <filesystem>
#include <utility>

namespace py = pybind11;

namespace isomatch::python {

std::vector<std::string> command_line(const SavedAs& saved, const cli::Json& options,
                                      const cli::Json& defaults) {
  std::vector<std::string> words{"isomatch",   "match", saved.source,
                                 saved.target, "-o",    saved.folder};
  for (const auto& [name, value] : options.items()) {
    if (defaults.contains(name) && value == defaults[name]) continue;
    words.push_back((value == false ? "--no-" : "--") + name);
    if (value.is_string()) words.push_back(value.get<std::string>());
    if (value.is_number()) words.push_back(value.dump());
  }
  return words;
}

void rename(cli::MatchInputs& inputs, const SavedAs& saved, std::vector<std::string> words) {
  inputs.words = std::move(words);
  inputs.working_folder = std::filesystem::current_path().string();
  inputs.source.path = saved.source;
  inputs.target.path = saved.target;
}

py::dict to_dict(const std::vector<StageTime>& times) {
  py::dict result;
  for (const StageTime& time : times) result[py::str(time.stage)] = time.seconds;
  return result;
}

}  // namespace isomatch::python
