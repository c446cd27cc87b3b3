// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/shown_match.h"

#include <utility>

namespace isomatch::results {
namespace {

MatchResult without_maps(const MatchInputs& inputs, const std::string& folder, Json report) {
  return {folder,
          std::move(report),
          inputs.source.path,
          inputs.target.path,
          inputs.source.mesh(),
          inputs.target.mesh(),
          {}};
}

Shapes shapes_of(const MatchInputs& inputs) { return {inputs.source.shape, inputs.target.shape}; }

}  // namespace

ShownMatch shown_match(const TrackedRun& run, const std::string& folder, Json report) {
  ShownMatch shown{without_maps(run.inputs, folder, std::move(report)),
                   relation(run),
                   {},
                   shapes_of(run.inputs)};
  for (std::size_t k = 0; k < run.result.maps.size(); ++k)
    shown.result.maps.push_back(result_map(run, k));
  return shown;
}

ShownMatch shown_match(const PaperRun& run, const std::string& folder, Json report) {
  ShownMatch shown{without_maps(run.inputs, folder, std::move(report)),
                   {},
                   result_levels(run),
                   shapes_of(run.inputs)};
  shown.relation = shown.levels.back().many_to_many.matches;
  shown.result.maps.push_back(result_map(run));
  return shown;
}

ShownMatch load_shown(const std::string& folder, const MeshPlaces& places) {
  MatchResult result = load_result(folder, places);
  Correspondence relation = load_relation(result);
  std::vector<ResultLevel> levels = load_levels(result);
  return {std::move(result), std::move(relation), std::move(levels), {}};
}

}  // namespace isomatch::results
