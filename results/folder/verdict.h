// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/measure/fit.h"
#include "isomatch/methods/paper.h"
#include "isomatch/methods/tracked.h"
#include "results/folder/inputs.h"
#include "results/json.h"

/// What the program says of a map that it made.
namespace isomatch::results {

/// `judge_fit` of each map; not good either if a shape has a grave defect, if landmarks contradict
/// the shapes, or if an alternative fits far worse than the best map. A stage of its own, which is
/// added to the times of `result`.
std::vector<Fit> fits_of(const MatchInputs& inputs, TrackedResult& result, const Context& context);
Fit fit_of(const MatchInputs& inputs, PaperResult& result, const Context& context);

/// The grade, the reasons and the measures, under their names.
Json to_json(const Fit& fit);
/// The way back. Throws `Json::exception` if it is not of that form.
Fit to_fit(const Json& json);

/// One line: the grade and the measures that a user can picture.
std::string describe(const Fit& fit);

/// Why the fit is not good, with the grade, a line each; none of a good one.
std::vector<std::string> remarks(const Fit& fit);

}  // namespace isomatch::results
