// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/outcome.h"

#include <fmt/format.h>

#include <utility>

#include "load.h"
#include "program/progress_bar.h"

namespace isomatch::cli {
namespace {

void warn_of_defects(const results::MatchInputs& inputs) {
  for (const results::MatchInput* input : {&inputs.source, &inputs.target})
    for (const std::string& warning : input->shape.diagnosis().warnings())
      warn_of(input->path, warning);
}

}  // namespace

void print_outcome(const results::MatchInputs& inputs, const Summary& summary, const Fit& fit,
                   const std::string& folder, bool quiet) {
  std::vector<std::string> all = results::remarks(fit);
  all.insert(all.end(), summary.remarks.begin(), summary.remarks.end());
  if (quiet) {
    for (const std::string& remark : all) warn(remark);
    warn_of_defects(inputs);
    return;
  }
  ProgressBar::make_room();
  for (const std::string& line : summary.lines) fmt::print("{}\n", line);
  fmt::print("{}\n", results::describe(fit));
  for (const std::string& remark : all) fmt::print("! {}\n", remark);
  for (const auto& [name, input] :
       {std::pair{"source", &inputs.source}, {"target", &inputs.target}}) {
    for (const std::string& warning : input->shape.diagnosis().warnings())
      fmt::print("! {}: {}\n", name, warning);
  }
  fmt::print("written to {}\n", folder);
}

}  // namespace isomatch::cli
