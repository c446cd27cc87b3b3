// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "isomatch/error.h"
#include "measure/fit_measures.h"
#include "shape/prepared_shape.h"

namespace isomatch {
namespace {

/// From where on a measure is doubtful, and poor. docs/results/verdict.md has how right and wrong
/// maps of the development pairs lie around these.
struct Limits {
  double doubtful, poor;
};

constexpr Limits kDistortedLimits{0.01, 0.04}, kDisplacementLimits{0.3, 0.45},
    kUnreliefLimits{0.4, 0.55}, kUnreachedLimits{0.004, 0.03}, kUnmatchedLimits{0.004, 0.03},
    kReversedLimits{0.045, 0.15}, kStretchLimits{0.21, 0.3};

/// Collects reasons with how far each is beyond its limit.
class Judge {
 public:
  void consider(double measure, const Limits& limits, std::string reason) {
    if (measure < limits.doubtful) return;
    grade_ = std::max(grade_, measure < limits.poor ? FitGrade::kDoubtful : FitGrade::kPoor);
    reasons_.emplace_back(measure / limits.doubtful, std::move(reason));
  }

  Fit fit(const FitMeasures& measures) {
    std::ranges::stable_sort(reasons_, std::greater(), &Reason::first);
    Fit fit{grade_, {}, measures};
    for (auto& [excess, reason] : reasons_) fit.reasons.push_back(std::move(reason));
    return fit;
  }

 private:
  using Reason = std::pair<double, std::string>;

  FitGrade grade_ = FitGrade::kGood;
  std::vector<Reason> reasons_;
};

std::string percent(double share) {
  return share < 0.095 ? fmt::format("{:.1f} %", 100 * share)
                       : fmt::format("{:.0f} %", 100 * share);
}

std::string describe_reversal(double share) {
  return share > 0.5 ? "it turns the surface over, as a left-right flip does"
                     : percent(share) + " of the source is turned over";
}

Fit judged(FitMeasures measures, const FitOptions& options) {
  if (options.mirrored && measures.reversed >= 0) measures.reversed = 1 - measures.reversed;
  Judge judge;
  judge.consider(measures.distorted, kDistortedLimits,
                 percent(measures.distorted) +
                     " of the source is torn or squeezed: distances there change by half and more");
  if (!options.parts)
    judge.consider(measures.displacement, kDisplacementLimits,
                   "a part ends elsewhere, or has no counterpart: its distances from all the rest "
                   "change");
  judge.consider(1 - measures.relief, kUnreliefLimits,
                 "bumps and hollows do not agree, as if front and back were exchanged");
  if (!options.parts) {
    judge.consider(measures.unreached, kUnreachedLimits,
                   percent(measures.unreached) + " of the target is not reached");
    judge.consider(measures.unmatched, kUnmatchedLimits,
                   percent(measures.unmatched) + " of the source is not matched");
  }
  judge.consider(measures.reversed, kReversedLimits, describe_reversal(measures.reversed));
  judge.consider(measures.stretch, kStretchLimits,
                 fmt::format("distances between neighbours change by {:.0f} % on average",
                             100 * std::expm1(measures.stretch)));
  return judge.fit(measures);
}

OnSurface<VertexMap> nearest_surface_vertices(const Shape& source, const Shape& target,
                                              const SurfaceMap& map) {
  const Surface& onto = *target.prepared().surface();
  return OnSurface(
      nearest_vertices(onto.mesh, *on_surfaces(*source.prepared().surface(), onto, map)));
}

}  // namespace

std::string_view to_string(FitGrade grade) {
  switch (grade) {
    case FitGrade::kGood:
      return "good";
    case FitGrade::kDoubtful:
      return "doubtful";
    case FitGrade::kPoor:
      return "poor";
  }
  throw InternalError("unknown grade of a fit");
}

Fit judge_fit(const Shape& source, const Shape& target, const SurfaceMap& source_to_target,
              const FitOptions& options, const Context& context) {
  const OnSurface<VertexMap> map = nearest_surface_vertices(source, target, source_to_target);
  return judged(measure_fit(source, target, map, options.scale, context), options);
}

Fit judge_fit(const Shape& source, const Shape& target, const VertexMap& source_to_target,
              const FitOptions& options, const Context& context) {
  const OnSurface<VertexMap> map =
      on_surfaces(*source.prepared().surface(), *target.prepared().surface(), source_to_target);
  return judged(measure_fit(source, target, map, options.scale, context), options);
}

}  // namespace isomatch
