// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/methods/paper.h"
#include "isomatch/methods/tracked.h"
#include "results/folder/inputs.h"
#include "results/folder/measured_matches.h"

/// Between the numbers of the surfaces, on which methods work, and those of the input meshes.
namespace isomatch::results {

/// Turns matches between the bases of a result of the paper's method into matches between input
/// vertices. Keeps references.
class InputNumbers {
 public:
  InputNumbers(const MatchInputs& inputs, const PaperResult& result);

  MeasuredMatches translate(const Correspondence& matches,
                            const std::vector<double>& distortion) const;
  VertexMap source_to_target() const;

 private:
  const MatchInputs& inputs_;
  const PaperResult& result_;
  std::vector<std::vector<int>> source_, target_;
};

/// A map between surfaces as one between input meshes.
SurfaceMap input_points(const MatchInput& from, const MatchInput& onto, const SurfaceMap& map);

/// `matches` of a tracked map, see there, between input vertices.
Correspondence input_matches(const MatchInputs& inputs, const TrackedMap& map);

/// Pairs of input vertices as pairs of surface vertices. Throws `InvalidInput` if one is out of
/// range or not part of the surface, or a source vertex has two landmarks.
Correspondence surface_landmarks(const MatchInputs& inputs, const std::vector<Match>& pairs);

}  // namespace isomatch::results
