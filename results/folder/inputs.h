// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/shape/shape.h"
#include "isomatch/stage_times.h"
#include "results/evaluation.h"
#include "results/warn.h"

namespace isomatch::results {

/// A mesh, where it came from, and what reading it told. Cheap to copy.
struct MatchInput {
  /// Empty if it is not from a file.
  std::string path;
  MeshReadReport read_report;
  Shape shape;

  const Mesh& mesh() const { return shape.mesh(); }
};

struct MatchInputs {
  /// The command line and the folder in which it was run.
  std::vector<std::string> words;
  std::string working_folder;
  MatchInput source, target;
  std::vector<StageTime> times;
};

/// Reads and inspects the meshes in the files `source` and `target`, at the same time if there are
/// threads, and checks `truth`, if there is one, against them. Reports progress up to `kLoaded`.
/// What readers warn of goes to `warn`, the source's first. `words` stay empty. Throws `BadFile`.
MatchInputs load_inputs(const std::string& source, const std::string& target,
                        const GeodesicOptions& geodesics, const TruthFiles& truth, const Warn& warn,
                        const Context& context);

/// Fractions of the progress at which the meshes are loaded, matched and the map is judged.
inline constexpr double kLoaded = 0.03, kMatched = 0.94, kJudged = 0.98;

/// `context` for matching, with its progress between these fractions. Keeps a reference.
Context matching_part(const Context& context);

}  // namespace isomatch::results
