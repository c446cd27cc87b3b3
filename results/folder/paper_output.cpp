// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/paper_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "isomatch/io/map_file.h"
#include "results/folder/base_matches.h"
#include "results/folder/report.h"

namespace isomatch::results {
namespace {

Json distortion_json(const std::vector<double>& d_iso) {
  const DistortionSummary summary = summarize(d_iso);
  return {{"d_iso_mean", summary.mean}, {"d_iso_max", summary.max}};
}

Json levels_json(const PaperResult& result) {
  Json levels = Json::array();
  for (const PaperLevel& level : result.levels)
    levels.push_back({{"level", levels.size()},
                      {"source_radius", level.source_radius},
                      {"target_radius", level.target_radius},
                      {"source_bases", level.source_bases},
                      {"target_bases", level.target_bases},
                      {"matches", level.matches.size()},
                      {"distortion", distortion_json(level.distortion)},
                      {"many_to_one_distortion", distortion_json(level.many_to_one_distortion)},
                      {"outliers_moved", level.outliers_moved}});
  return levels;
}

Json report_json(const PaperRun& run, const std::vector<StageTime>& times) {
  const PaperLevel& last = run.result.levels.back();
  Json report = report_head(run.inputs, run.options);
  report["source"]["max_geodesic"] = run.max_geodesics[0];
  report["target"]["max_geodesic"] = run.max_geodesics[1];
  report.update({{"levels", run.result.levels.size()},
                 {"complete", run.result.complete},
                 {"matches", last.matches.size()},
                 {"distortion", distortion_json(last.distortion)},
                 {"many_to_one_distortion", distortion_json(last.many_to_one_distortion)},
                 {"fit", to_json(run.fit)}});
  report.update(report_tail(times));
  return report;
}

std::string level_file(std::size_t level, std::string_view name) {
  return fmt::format("levels/{:02}.{}.txt", level, name);
}

void write_matches(ResultFolder& folder, const std::string& name, const MeasuredMatches& measured) {
  write_correspondence(folder.add(name), measured.matches, measured.distortion);
}

void write_levels(ResultFolder& folder, const std::vector<ResultLevel>& levels) {
  for (std::size_t k = 0; k < levels.size(); ++k) {
    write_matches(folder, level_file(k, "correspondence"), levels[k].many_to_many);
    write_matches(folder, level_file(k, "many_to_one"), levels[k].many_to_one);
  }
}

}  // namespace

std::vector<std::string> paper_files(int max_levels) {
  // No mesh has as many levels.
  constexpr int kMostLevels = 1000;
  std::vector<std::string> files{"source_to_target.txt", "correspondence.txt", "levels.json"};
  for (int k = 0; k <= std::min(max_levels, kMostLevels); ++k)
    for (const char* name : {"correspondence", "many_to_one"}) files.push_back(level_file(k, name));
  return files;
}

ResultMap result_map(const PaperRun& run) {
  const VertexMap& vertices = run.result.source_to_target;
  return {{}, vertices, corner_points(run.inputs.target.mesh(), vertices), {}};
}

std::vector<ResultLevel> result_levels(const PaperRun& run) {
  const auto numbered = [&](const Correspondence& matches, const std::vector<double>& distortion) {
    return between_vertices(run.inputs, run.result, matches, distortion);
  };
  std::vector<ResultLevel> levels;
  for (const PaperLevel& level : run.result.levels)
    levels.push_back(
        {numbered(level.matches, level.distortion),
         numbered(to_correspondence(level.many_to_one), level.many_to_one_distortion)});
  return levels;
}

Json write_paper(const ResultPlan& plan, const PaperRun& run) {
  std::vector<StageTime> times = joined(run.inputs.times, run.result.times);
  ResultFolder folder(plan);
  {
    const StageTimer timer(times, "writing");
    const std::vector<ResultLevel> levels = result_levels(run);
    write_levels(folder, levels);
    write_matches(folder, "correspondence.txt", levels.back().many_to_many);
    write_map(folder.add("source_to_target.txt"),
              {.source_to_target = run.result.source_to_target});
    folder.write_json("levels.json", levels_json(run.result));
  }
  return folder.write_report(report_json(run, times));
}

}  // namespace isomatch::results
