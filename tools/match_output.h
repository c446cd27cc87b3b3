// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isomatch/diagnosis.h"
#include "isomatch/mesh_io.h"
#include "isomatch/paper.h"
#include "json.h"

namespace isomatch::cli {

struct MatchInput {
  std::string path;
  Mesh mesh;
  MeshReadReport read_report;
  MeshDiagnosis diagnosis;
  Shape shape;
};

/// Everything that a match leaves behind.
struct MatchRun {
  MatchInput source, target;
  Json options;
  PaperResult result;
  std::vector<StageTime> times;
};

/// Writes into `folder`, which is created if need be, in the numbers of the input files:
/// - source_to_target.txt: the target vertex of every source vertex;
/// - correspondence.txt: the many-to-many result, with d_iso;
/// - levels/KK.correspondence.txt and levels/KK.many_to_one.txt: xi(k) and xi(k,1) of level k;
/// - levels.json and report.json.
/// Each file appears whole or not at all. Throws `BadFile`.
void write_match(const std::string& folder, const MatchRun& run);

}  // namespace isomatch::cli
