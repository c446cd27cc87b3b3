// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "results/page/page.h"

namespace py = pybind11;

namespace isomatch::python {

results::ResultPlan make_plan(const SavedAs& saved, std::vector<std::string> files) {
  files.insert(files.end(), saved.arrays.begin(), saved.arrays.end());
  if (saved.page) files.emplace_back(results::kPage);
  results::ResultPlan plan{saved.folder, std::move(files), {}, saved.arrays};
  for (const auto& [input, array] : {std::pair(saved.source, "source.ply"),
                                     {saved.target, "target.ply"},
                                     {saved.landmarks, "landmarks.txt"}})
    if (!input.empty() && std::ranges::count(saved.arrays, array) == 0) plan.inputs.add(input);
  return plan;
}

void check_save(const SavedAs& saved, std::vector<std::string> files) {
  if (saved.page) results::check_page_available();
  results::ResultPlan plan = make_plan(saved, std::move(files));
  plan.ready.clear();
  results::check_plan(plan);
}

void add_flags(std::vector<std::string>& words, const results::Json& options,
               const results::Json& defaults) {
  for (const auto& [name, value] : options.items()) {
    if ((defaults.contains(name) && value == defaults[name]) || name.ends_with("_escaped"))
      continue;
    words.push_back((value == false ? "--no-" : "--") + name);
    if (value.is_string()) words.push_back(results::get_path(options, name));
    if (value.is_number()) words.push_back(value.dump());
  }
}

std::vector<std::string> command_line(const SavedAs& saved, const results::Json& options,
                                      const results::Json& defaults) {
  std::vector<std::string> words{"isomatch",   "match", saved.source,
                                 saved.target, "-o",    saved.folder};
  add_flags(words, options, defaults);
  return words;
}

void rename(results::MatchInputs& inputs, const SavedAs& saved, std::vector<std::string> words) {
  inputs.words = std::move(words);
  inputs.working_folder = std::filesystem::current_path().string();
  inputs.source.path = saved.source;
  inputs.target.path = saved.target;
}

void save_page(const SavedAs& saved, const std::function<results::ShownMatch()>& shown,
               const RunOptions& how) {
  const std::string path = (std::filesystem::path(saved.folder) / results::kPage).string();
  run_work(how, [&](const Context& context) { results::write_page(path, shown(), {}, context); });
}

py::dict to_dict(const std::vector<StageTime>& times) {
  py::dict result;
  for (const StageTime& time : times) result[py::str(time.stage)] = time.seconds;
  return result;
}

py::dict to_dict(const Fit& fit) {
  const FitMeasures& measures = fit.measures;
  py::dict dict;
  dict["grade"] = py::str(std::string(to_string(fit.grade)));
  dict["reasons"] = py::cast(fit.reasons);
  dict["stretch"] = measures.stretch;
  dict["distorted"] = measures.distorted;
  dict["displacement"] = measures.displacement;
  dict["relief"] = measures.relief;
  dict["unreached"] = measures.unreached;
  dict["unmatched"] = measures.unmatched;
  dict["reversed"] =
      measures.reversed < 0 ? py::object(py::none()) : py::object(py::float_(measures.reversed));
  return dict;
}

}  // namespace isomatch::python
