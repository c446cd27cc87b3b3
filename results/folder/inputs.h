// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/io/mesh_io.h"
#include "isomatch/mesh/diagnosis.h"
#include "isomatch/stage_times.h"
#include "match/method.h"
#include "results/folder/result_folder.h"

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

/// What `isomatch match` is going to write besides `files` of its method: the page, if it is asked
/// for. Of what it reads nothing may be touched, nor `more`, which may be empty.
ResultPlan make_plan(const MatchArguments& arguments, std::vector<std::string> files,
                     const std::string& more = "");

/// Reads and inspects both meshes, at the same time if there are threads, and checks the truth
/// against them. Reports progress up to `kLoaded`. Throws `BadFile`.
MatchInputs load_inputs(const MatchArguments& arguments, const Context& context);

/// Tells of all defects on standard error, where no summary does.
void warn_of_defects(const MatchInputs& inputs);

/// Input vertices of each surface vertex: several where a seam was joined.
std::vector<std::vector<int>> input_vertices(const Surface& surface);

/// Fractions of the progress at which the meshes are loaded, matched and the map is judged.
inline constexpr double kLoaded = 0.03, kMatched = 0.94, kJudged = 0.98;

/// `context` for matching, with its progress between these fractions. Keeps a reference.
Context matching_part(const Context& context);

}  // namespace isomatch::cli
