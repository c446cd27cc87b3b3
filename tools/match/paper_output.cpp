// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/paper_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "isomatch/map_io.h"
#include "match/report.h"
#include "match/result_folder.h"

namespace isomatch::cli {
namespace {

/// A correspondence with a distortion for each match.
struct MeasuredMatches {
  Correspondence matches;
  std::vector<double> distortion;
};

void sort_by_match(MeasuredMatches& measured) {
  std::vector<std::size_t> order(measured.matches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return measured.matches[i]; });
  MeasuredMatches sorted;
  for (std::size_t i : order) {
    sorted.matches.push_back(measured.matches[i]);
    sorted.distortion.push_back(measured.distortion[i]);
  }
  measured = std::move(sorted);
}

/// Turns matches between bases into matches between vertices of the input files.
class InputNumbers {
 public:
  explicit InputNumbers(const PaperRun& run)
      : run_(run),
        source_(input_vertices(run.inputs.source.surface)),
        target_(input_vertices(run.inputs.target.surface)) {}

  MeasuredMatches translate(const Correspondence& matches,
                            const std::vector<double>& distortion) const {
    MeasuredMatches result;
    for (std::size_t m = 0; m < matches.size(); ++m) {
      for (int s : source_[run_.result.source_bases[matches[m].source]]) {
        for (int t : target_[run_.result.target_bases[matches[m].target]]) {
          result.matches.push_back({s, t});
          result.distortion.push_back(distortion[m]);
        }
      }
    }
    sort_by_match(result);
    return result;
  }

  VertexMap source_to_target() const {
    VertexMap map(run_.inputs.source.mesh.vertices.size(), kUnmatched);
    for (std::size_t v = 0; v < source_.size(); ++v) {
      const int image = run_.result.source_to_target[v];
      if (image == kUnmatched) continue;
      for (int s : source_[v]) map[s] = target_[image].front();
    }
    return map;
  }

 private:
  const PaperRun& run_;
  std::vector<std::vector<int>> source_, target_;
};

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
                 {"many_to_one_distortion", distortion_json(last.many_to_one_distortion)}});
  report.update(report_tail(times));
  return report;
}

void write_levels(ResultFolder& folder, const PaperResult& result, const InputNumbers& numbers) {
  for (std::size_t k = 0; k < result.levels.size(); ++k) {
    const PaperLevel& level = result.levels[k];
    const auto write = [&](std::string_view name, const MeasuredMatches& measured) {
      write_correspondence(folder.add(fmt::format("levels/{:02}.{}.txt", k, name)),
                           measured.matches, measured.distortion);
    };
    write("correspondence", numbers.translate(level.matches, level.distortion));
    write("many_to_one",
          numbers.translate(to_correspondence(level.many_to_one), level.many_to_one_distortion));
  }
}

}  // namespace

void write_paper(const std::string& path, const PaperRun& run) {
  std::vector<StageTime> times = joined(run.inputs.times, run.result.times);
  ResultFolder folder(path);
  {
    const StageTimer timer(times, "writing");
    const InputNumbers numbers(run);
    const PaperLevel& last = run.result.levels.back();
    const MeasuredMatches final_matches = numbers.translate(last.matches, last.distortion);
    write_levels(folder, run.result, numbers);
    write_correspondence(folder.add("correspondence.txt"), final_matches.matches,
                         final_matches.distortion);
    write_source_to_target(folder.add("source_to_target.txt"), numbers.source_to_target());
    folder.write_json("levels.json", levels_json(run.result));
  }
  folder.write_report(report_json(run, times));
}

}  // namespace isomatch::cli
