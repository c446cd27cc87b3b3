// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/mesh/diagnosis.h"
#include "isomatch/stage_times.h"
#include "results/evaluation.h"
#include "results/warn.h"

namespace isomatch::results {

struct MatchInput {
  std::string path;
  Mesh mesh;
  MeshReadReport read_report;
  MeshDiagnosis diagnosis;
  Surface surface;
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
                        const TruthFiles& truth, const Warn& warn, const Context& context);

/// Input vertices of each surface vertex: several where a seam was joined.
std::vector<std::vector<int>> input_vertices(const Surface& surface);

/// Fractions of the progress at which the meshes are loaded, matched and the map is judged.
inline constexpr double kLoaded = 0.03, kMatched = 0.94, kJudged = 0.98;

/// `context` for matching, with its progress between these fractions. Keeps a reference.
Context matching_part(const Context& context);

}  // namespace isomatch::results
