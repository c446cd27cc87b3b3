// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isomatch/io/map_file.h"
#include "isomatch/measure/metrics.h"
#include "isomatch/measure/overlap.h"
#include "isomatch/measure/registered_surface.h"
#include "results/json.h"

namespace isomatch::results {

/// Files that hold the ground truth between two meshes; empty where there is none.
struct TruthFiles {
  std::string source, target;
  /// Of the target under its left-right symmetry.
  std::string symmetric_target{};
  /// A map of every vertex of the source.
  std::string map{};
};

/// The same as vertices of the input meshes: entry i of each list is the place of template point i,
/// `kUnmatched` where the mesh lacks it.
struct TruthVertices {
  std::vector<int> source, target;
  std::vector<int> symmetric_target;
};

/// Reads the truth between meshes of so many vertices. Throws `BadFile` as `read_ground_truth`, and
/// if its files differ in length.
TruthVertices read_truth(const TruthFiles& files, VertexCounts counts);

/// Reads a truth for every vertex of the source: a map in any format, numbered from zero unless its
/// format has a numbering of its own. Points count where a file has both. Throws `BadFile` as
/// `read_map`.
TrueMap read_true_map(const std::string& file, const Shape& source, const Shape& target);

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
  /// By template points.
  OverlapQuality overlap;
  ErrorStatistics template_errors;
  /// Of a map to points on triangles.
  std::optional<ErrorStatistics> point_errors;
  ErrorStatistics match_errors;
};

/// Against a truth for every vertex of the source, on the overlap.
struct TrueMapEvaluation {
  /// By area of the source.
  OverlapQuality overlap;
  OverlapErrors match_errors;
  /// Of a map to points on triangles.
  std::optional<OverlapErrors> point_errors;
};

/// What a map is measured against, as far as it is known.
struct Truth {
  TruthVertices vertices;
  std::optional<TrueMap> map;
};

/// All that `isomatch eval` says of a map.
struct Evaluation {
  IsometricDistortion distortion;
  Coverage coverage;
  MapOrientation orientation;
  std::optional<TruthEvaluation> truth;
  std::optional<TruthEvaluation> symmetric_truth;
  std::optional<TrueMapEvaluation> true_map;
  /// Of the source bent onto the target, if that is given.
  std::optional<RegisteredSurface> registered;

  bool flipped() const {
    return symmetric_truth && symmetric_truth->template_errors.mean < truth->template_errors.mean;
  }
};

/// Measures `map` against itself and against `truth`. Throws `InvalidInput` if its lists differ in
/// length or name vertices that are not there.
Evaluation evaluate(const Shape& source, const Shape& target, const MeasuredMap& map,
                    const Truth& truth, const EvaluationOptions& options, const Context& context);

/// The same with the truth in `files`. Throws `BadFile`.
Evaluation evaluate(const Shape& source, const Shape& target, const MeasuredMap& map,
                    const TruthFiles& files, const EvaluationOptions& options,
                    const Context& context);

Json to_json(const Evaluation& evaluation);

}  // namespace isomatch::results
