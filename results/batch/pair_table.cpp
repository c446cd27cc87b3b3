// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <optional>
#include <string>

#include "isomatch/io/atomic_file.h"
#include "results/batch/batch.h"
#include "results/csv.h"

namespace isomatch::results {
namespace {

/// Empty where there is none.
std::string figure(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

std::string line(const PairOutcome& outcome) {
  const ListedPair& pair = outcome.pair;
  const std::string names =
      fmt::format("{},{},{}", csv_field(pair.name), csv_field(pair.source), csv_field(pair.target));
  if (!outcome.matched()) {
    constexpr int kColumnsOfMaps = 13;
    return fmt::format("{},failed,{}{}\n", names, std::string(kColumnsOfMaps, ','),
                       csv_field(outcome.error));
  }
  const PairSummary& summary = outcome.summary;
  return fmt::format("{},matched,{},{},{},{:.6g},{:.6g},{:.6g},{},{},{},{},{},{:.3f},{:.1f},\n",
                     names, summary.grade, summary.matched_vertices, summary.unmatched_vertices,
                     summary.stretch, summary.unreached, summary.ambiguity,
                     figure(summary.mean_confidence), summary.mirrored ? 1 : 0,
                     figure(summary.point_error), csv_field(summary.reasons),
                     csv_field(summary.warnings), summary.seconds, summary.peak_memory_mib);
}

}  // namespace

void write_pair_table(const std::string& path, const std::vector<PairOutcome>& outcomes) {
  AtomicFile file(path);
  file.write(
      "name,source,target,outcome,fit,source_vertices_matched,source_vertices_unmatched,stretch,"
      "unreached,ambiguity,mean_confidence,mirrored,point_error_over_sqrt_area,reasons,warnings,"
      "seconds,peak_memory_mib,error\n");
  for (const PairOutcome& outcome : outcomes) file.write(line(outcome));
  file.commit();
}

}  // namespace isomatch::results
