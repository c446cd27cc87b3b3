// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/paper_output.h"

#include <fmt/format.h>

#include <algorithm>

#include "isomatch/io/map_file.h"
#include "results/folder/input_numbers.h"
#include "results/folder/report.h"

namespace isomatch::cli {
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

void write_levels(ResultFolder& folder, const PaperResult& result, const InputNumbers& numbers) {
  for (std::size_t k = 0; k < result.levels.size(); ++k) {
    const PaperLevel& level = result.levels[k];
    const auto write = [&](std::string_view name, const MeasuredMatches& measured) {
      write_correspondence(folder.add(level_file(k, name)), measured.matches, measured.distortion);
    };
    write("correspondence", numbers.translate(level.matches, level.distortion));
    write("many_to_one",
          numbers.translate(to_correspondence(level.many_to_one), level.many_to_one_distortion));
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

void write_paper(const ResultPlan& plan, const PaperRun& run) {
  std::vector<StageTime> times = joined(run.inputs.times, run.result.times);
  ResultFolder folder(plan);
  {
    const StageTimer timer(times, "writing");
    const InputNumbers numbers(run.inputs, run.result);
    const PaperLevel& last = run.result.levels.back();
    const MeasuredMatches final_matches = numbers.translate(last.matches, last.distortion);
    write_levels(folder, run.result, numbers);
    write_correspondence(folder.add("correspondence.txt"), final_matches.matches,
                         final_matches.distortion);
    write_map(folder.add("source_to_target.txt"), {.source_to_target = numbers.source_to_target()});
    folder.write_json("levels.json", levels_json(run.result));
  }
  folder.write_report(report_json(run, times));
}

}  // namespace isomatch::cli
