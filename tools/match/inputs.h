// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/diagnosis.h"
#include "isomatch/mesh_io.h"
#include "isomatch/stage_times.h"
#include "match/method.h"

namespace isomatch::cli {

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

/// Checks that the results will have a place, then reads and inspects both meshes, at the same time
/// if there are threads. Reports progress up to `kLoaded`. Throws `BadFile`.
MatchInputs load_inputs(const MatchArguments& arguments, const Context& context);

/// Input vertices of each surface vertex: several where a seam was joined.
std::vector<std::vector<int>> input_vertices(const Surface& surface);

/// Fractions of the progress at which matching begins and writing begins.
inline constexpr double kLoaded = 0.1, kMatched = 0.95;

/// `context` for matching, with its progress between these fractions. Keeps a reference.
Context matching_part(const Context& context);

}  // namespace isomatch::cli
