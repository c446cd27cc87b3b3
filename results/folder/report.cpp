// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/report.h"

#include "isomatch/version.h"

namespace isomatch::results {
namespace {

Json input_json(const MatchInput& input) {
  Json json;
  set_path(json, "file", input.path);
  json.update({{"triangulated_polygons", input.read_report.triangulated_polygons},
               {"merged_vertices", input.read_report.merged_vertices},
               {"read_warnings", input.read_report.warnings}});
  json.update(to_json(input.shape.diagnosis()));
  return json;
}

}  // namespace

Json report_head(const MatchInputs& inputs, const Json& options) {
  Json head{{"isomatch", kVersion}};
  set_paths(head, "command", inputs.words);
  set_path(head, "working_folder", inputs.working_folder);
  head.update({{"options", options},
               {"source", input_json(inputs.source)},
               {"target", input_json(inputs.target)}});
  return head;
}

std::vector<StageTime> joined(std::vector<StageTime> loading,
                              const std::vector<StageTime>& matching) {
  loading.insert(loading.end(), matching.begin(), matching.end());
  return loading;
}

Json report_tail(const std::vector<StageTime>& times) {
  Json seconds = Json::object(), peaks = Json::object();
  for (const StageTime& time : times) {
    seconds[time.stage] = time.seconds;
    peaks[time.stage] = time.peak_memory_mib;
  }
  return {{"seconds", seconds},
          {"peak_memory_mib", peak_memory_mib()},
          {"peak_memory_mib_after", peaks}};
}

Json options_json(const std::string& method) { return {{"method", method}}; }

}  // namespace isomatch::results
