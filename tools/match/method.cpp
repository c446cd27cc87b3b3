// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/method.h"

#include <utility>

#include "load.h"

namespace isomatch::cli {

results::ResultPlan make_plan(const MatchArguments& arguments, std::vector<std::string> files,
                              const std::string& more) {
  if (arguments.page) files.emplace_back(results::kPage);
  return {arguments.folder, std::move(files),
          results::InputFiles({arguments.source, arguments.target, arguments.truth.source,
                               arguments.truth.target, more})};
}

results::MatchInputs load_inputs(const MatchArguments& arguments, const GeodesicOptions& geodesics,
                                 const Context& context) {
  results::MatchInputs inputs = results::load_inputs(arguments.source, arguments.target, geodesics,
                                                     arguments.truth, warn_of, context);
  inputs.words = arguments.words;
  return inputs;
}

}  // namespace isomatch::cli
