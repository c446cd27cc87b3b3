// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isomatch::results {
namespace {

constexpr const char* kStage = "fit";

void doubt(Fit& fit, std::string reason) {
  fit.grade = std::max(fit.grade, FitGrade::kDoubtful);
  fit.reasons.push_back(std::move(reason));
}

template <class Map>
Fit fit_of(const MatchInputs& inputs, const Map& map, const FitOptions& options,
           const Context& context) {
  Fit fit = judge_fit(inputs.source.shape, inputs.target.shape, map, options, context);
  for (const auto& [name, input] :
       {std::pair{"source", &inputs.source}, {"target", &inputs.target}}) {
    if (!input->shape.diagnosis().grave_warnings().empty())
      doubt(fit, fmt::format("the {} has a grave defect, see there", name));
  }
  return fit;
}

/// How many times as long a unit of the source's is on the target, both being of unit area.
double scale_between(const MatchInputs& inputs, const PairView& view) {
  const double source = std::sqrt(inputs.source.shape.area()) / view.source_unit,
               target = std::sqrt(inputs.target.shape.area()) / view.target_unit;
  return source / target;
}

/// Says so of an alternative that fits worse than the best map by more than right maps differ.
void compare(const TrackedMap& best, const TrackedMap& alternative, Fit& fit) {
  constexpr double kWorse = 1.5;
  const double times = alternative.cost() / std::max(best.cost(), 1e-300);
  if (times >= kWorse) doubt(fit, fmt::format("the best map fits {:.1f} times better", times));
}

}  // namespace

std::vector<Fit> fits_of(const MatchInputs& inputs, TrackedResult& result, const Context& context) {
  context.report(kMatched, kStage);
  const StageTimer timer(result.times, kStage);
  const PairView& view = result.taken_for;
  std::vector<Fit> fits;
  for (const TrackedMap& map : result.maps) {
    fits.push_back(fit_of(inputs, map.source_to_target,
                          {.parts = view.source_is_part || view.target_is_part,
                           .scale = scale_between(inputs, view),
                           .mirrored = map.mirrored},
                          context));
    compare(result.maps.front(), map, fits.back());
    if (!result.contradicted_landmarks.empty())
      doubt(fits.back(), "landmarks contradict the shapes");
  }
  return fits;
}

Fit fit_of(const MatchInputs& inputs, PaperResult& result, const Context& context) {
  context.report(kMatched, kStage);
  const StageTimer timer(result.times, kStage);
  return fit_of(inputs, result.source_to_target, {}, context);
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

Fit to_fit(const Json& json) {
  Fit fit;
  const std::string grade = json.at("grade");
  for (FitGrade known : {FitGrade::kGood, FitGrade::kDoubtful, FitGrade::kPoor})
    if (grade == to_string(known)) fit.grade = known;
  fit.reasons = json.at("reasons").get<std::vector<std::string>>();
  FitMeasures& measures = fit.measures;
  measures.stretch = json.at("stretch");
  measures.distorted = json.at("distorted");
  measures.displacement = json.at("displacement");
  measures.relief = json.at("relief");
  measures.unreached = json.at("unreached");
  measures.unmatched = json.at("unmatched");
  measures.reversed = json.at("reversed").is_null() ? -1 : json.at("reversed").get<double>();
  return fit;
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

}  // namespace isomatch::results
