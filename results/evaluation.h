// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isomatch/io/map_file.h"
#include "isomatch/measure/metrics.h"
#include "results/json.h"

namespace isomatch::results {

/// Files that hold the ground truth between two meshes; empty where there is none.
struct TruthFiles {
  std::string source, target;
  /// Of the target under its left-right symmetry.
  std::string symmetric_target;
};

/// The same as vertices of the input meshes: entry i of each list is the place of template point i.
struct TruthVertices {
  std::vector<int> source, target;
  std::vector<int> symmetric_target;
};

/// Reads the truth between meshes of so many vertices. Throws `BadFile` as `read_ground_truth`, and
/// if its files differ in length.
TruthVertices read_truth(const TruthFiles& files, VertexCounts counts);

/// A map that is measured.
struct MeasuredMap {
  Correspondence matches;
  /// Where it leads to points on triangles.
  std::optional<SurfaceMap> points;
};

/// What a file holds. Points count where it has both.
MeasuredMap measured_map(const Shape& target, const MatchContent& content);

struct EvaluationOptions {
  TruthOptions truth;
  DistortionOptions distortion;
};

/// Errors against one ground truth.
struct TruthEvaluation {
  /// Template points in the files, and those that lie on both surfaces.
  std::size_t points_in_files = 0;
  int points = 0;
  ErrorStatistics template_errors;
  /// Of a map to points on triangles.
  std::optional<ErrorStatistics> point_errors;
  ErrorStatistics match_errors;
};

/// All that `isomatch eval` says of a map.
struct Evaluation {
  IsometricDistortion distortion;
  Coverage coverage;
  MapOrientation orientation;
  std::optional<TruthEvaluation> truth;
  std::optional<TruthEvaluation> symmetric_truth;

  bool flipped() const {
    return symmetric_truth && symmetric_truth->template_errors.mean < truth->template_errors.mean;
  }
};

/// Measures `map` against itself and against `truth`. Throws `InvalidInput` if its lists differ in
/// length or name vertices that are not there.
Evaluation evaluate(const Shape& source, const Shape& target, const MeasuredMap& map,
                    const TruthVertices& truth, const EvaluationOptions& options,
                    const Context& context);

/// The same with the truth in `files`. Throws `BadFile`.
Evaluation evaluate(const Shape& source, const Shape& target, const MeasuredMap& map,
                    const TruthFiles& files, const EvaluationOptions& options,
                    const Context& context);

Json to_json(const Evaluation& evaluation);

}  // namespace isomatch::results
