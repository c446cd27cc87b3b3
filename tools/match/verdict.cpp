// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isomatch::cli {

Fit fit_of(const MatchInputs& inputs, const SurfaceMap& map, const FitOptions& options,
           const Context& context) {
  Fit fit = judge_fit(inputs.source.surface, inputs.target.surface, map, options, context);
  for (const auto& [name, input] :
       {std::pair{"source", &inputs.source}, {"target", &inputs.target}}) {
    if (input->diagnosis.grave_warnings().empty()) continue;
    fit.grade = std::max(fit.grade, FitGrade::kDoubtful);
    fit.reasons.push_back(fmt::format("the {} has a grave defect, see there", name));
  }
  return fit;
}

Json to_json(const Fit& fit) {
  const FitMeasures& measures = fit.measures;
  Json reversed;
  if (measures.reversed >= 0) reversed = measures.reversed;
  return {{"grade", to_string(fit.grade)},
          {"reasons", fit.reasons},
          {"stretch", measures.stretch},
          {"distorted", measures.distorted},
          {"displacement", measures.displacement},
          {"relief", measures.relief},
          {"unreached", measures.unreached},
          {"unmatched", measures.unmatched},
          {"reversed", reversed}};
}

std::string describe(const Fit& fit) {
  return fmt::format(
      "fit: {} (distances between neighbours change by {:.0f} % on average, {:.1f} % of the target "
      "is reached)",
      to_string(fit.grade), 100 * std::expm1(fit.measures.stretch),
      100 * (1 - fit.measures.unreached));
}

std::vector<std::string> remarks(const Fit& fit) {
  std::vector<std::string> lines;
  for (const std::string& reason : fit.reasons)
    lines.push_back(fmt::format("{} fit: {}", to_string(fit.grade), reason));
  return lines;
}

}  // namespace isomatch::cli
