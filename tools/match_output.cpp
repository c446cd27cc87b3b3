// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match_output.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "isomatch/atomic_file.h"
#include "isomatch/error.h"
#include "isomatch/map_io.h"
#include "isomatch/version.h"

namespace isomatch::cli {
namespace {

namespace fs = std::filesystem;

/// A correspondence with a distortion for each match.
struct MeasuredMatches {
  Correspondence matches;
  std::vector<double> distortion;
};

/// Input vertices of each surface vertex: several where a seam was joined.
std::vector<std::vector<int>> input_vertices(const Surface& surface) {
  std::vector<std::vector<int>> vertices(surface.num_vertices());
  for (std::size_t v = 0; v < surface.surface_vertex.size(); ++v) {
    if (surface.surface_vertex[v] != kNoVertex)
      vertices[surface.surface_vertex[v]].push_back(static_cast<int>(v));
  }
  return vertices;
}

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
  explicit InputNumbers(const MatchRun& run)
      : run_(run),
        source_(input_vertices(run.source.shape.surface)),
        target_(input_vertices(run.target.shape.surface)) {}

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
    VertexMap map(run_.source.mesh.vertices.size(), kUnmatched);
    for (std::size_t v = 0; v < source_.size(); ++v) {
      const int image = run_.result.source_to_target[v];
      if (image == kUnmatched) continue;
      for (int s : source_[v]) map[s] = target_[image].front();
    }
    return map;
  }

 private:
  const MatchRun& run_;
  std::vector<std::vector<int>> source_, target_;
};

void write_json(const fs::path& path, const Json& json) {
  AtomicFile file(path.string());
  file.write(json.dump(2) + "\n");
  file.commit();
}

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

Json input_json(const MatchInput& input) {
  Json json{{"file", input.path},
            {"triangulated_polygons", input.read_report.triangulated_polygons},
            {"merged_vertices", input.read_report.merged_vertices},
            {"max_geodesic", input.shape.max_geodesic}};
  json.update(to_json(input.diagnosis));
  return json;
}

/// Of this process so far, in MiB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Json report_json(const MatchRun& run) {
  Json seconds = Json::object();
  for (const StageTime& time : run.times) seconds[time.stage] = time.seconds;
  const PaperLevel& last = run.result.levels.back();
  return {{"isomatch", kVersion},
          {"options", run.options},
          {"source", input_json(run.source)},
          {"target", input_json(run.target)},
          {"levels", run.result.levels.size()},
          {"complete", run.result.complete},
          {"matches", last.matches.size()},
          {"distortion", distortion_json(last.distortion)},
          {"many_to_one_distortion", distortion_json(last.many_to_one_distortion)},
          {"seconds", seconds},
          {"peak_memory_mib", peak_memory()}};
}

void write_levels(const fs::path& folder, const PaperResult& result, const InputNumbers& numbers) {
  for (std::size_t k = 0; k < result.levels.size(); ++k) {
    const PaperLevel& level = result.levels[k];
    const auto write = [&](std::string_view name, const MeasuredMatches& measured) {
      write_correspondence((folder / fmt::format("{:02}.{}.txt", k, name)).string(),
                           measured.matches, measured.distortion);
    };
    write("correspondence", numbers.translate(level.matches, level.distortion));
    write("many_to_one",
          numbers.translate(to_correspondence(level.many_to_one), level.many_to_one_distortion));
  }
}

void create_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw BadFile(path.string(), "cannot be created: " + error.message());
}

}  // namespace

void write_match(const std::string& folder, const MatchRun& run) {
  const fs::path path = folder;
  create_folder(path / "levels");
  const InputNumbers numbers(run);
  const PaperLevel& last = run.result.levels.back();
  const MeasuredMatches final_matches = numbers.translate(last.matches, last.distortion);
  write_levels(path / "levels", run.result, numbers);
  write_correspondence((path / "correspondence.txt").string(), final_matches.matches,
                       final_matches.distortion);
  write_source_to_target((path / "source_to_target.txt").string(), numbers.source_to_target());
  write_json(path / "levels.json", levels_json(run.result));
  write_json(path / "report.json", report_json(run));
}

}  // namespace isomatch::cli
