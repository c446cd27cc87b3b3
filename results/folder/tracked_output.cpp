// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/tracked_output.h"

#include <fmt/format.h>

#include <algorithm>

#include "isomatch/io/map_file.h"
#include "isomatch/io/values_io.h"
#include "isomatch/mesh/topology.h"
#include "results/folder/report.h"

namespace isomatch::results {
namespace {

int count_points(const SurfaceMap& map) {
  const auto has_face = [](const SurfacePoint& point) { return point.face != kNoFace; };
  return static_cast<int>(std::ranges::count_if(map, has_face));
}

/// Writes a map in both forms, as `stem`.txt and `stem`.bary.txt.
void write_points(ResultFolder& folder, const std::string& stem, const VertexMap& vertices,
                  const SurfaceMap& points) {
  isomatch::write_map(folder.add(stem + ".txt"), {.source_to_target = vertices});
  isomatch::write_map(folder.add(stem + ".bary.txt"), {.points = points});
}

void write_confidence(ResultFolder& folder, const std::string& name,
                      const std::vector<float>& confidence) {
  const Eigen::Map<const Eigen::VectorXf> values(confidence.data(), std::ssize(confidence));
  write_values(folder.add(name), values.cast<double>());
}

std::string alternative_folder(std::size_t number) {
  return fmt::format("alternatives/{}", number);
}

void write_map(ResultFolder& folder, const TrackedRun& run, std::size_t k) {
  const Mesh& source = run.inputs.source.mesh();
  const ResultMap map = result_map(run, k);
  const std::string place = map.folder.empty() ? "" : map.folder + "/";
  write_points(folder, place + "source_to_target", map.source_to_target, map.points);
  if (run.target_to_source) {
    const SurfaceMap& inverse = run.result.maps[k].target_to_source;
    write_points(folder, place + "target_to_source", nearest_vertices(source, inverse), inverse);
  }
  write_confidence(folder, place + "source_confidence.txt", map.source_confidence);
  if (run.target_to_source)
    write_confidence(folder, place + "target_confidence.txt", map.target_confidence);
  write_mesh(folder.add(place + "registered.ply"), {map.registered, source.faces});
}

Json map_json(const TrackedMap& map) {
  return {{"energy", map.energy},           {"distance", map.distance},
          {"deviation", map.deviation},     {"distortion", map.distortion},
          {"orientation", map.orientation}, {"mirrored", map.mirrored}};
}

Json view_json(const PairView& view) {
  const auto word = [](bool is_part) { return is_part ? "part" : "whole"; };
  return {{"source", word(view.source_is_part)},
          {"target", word(view.target_is_part)},
          {"scale", view.scale},
          {"source_unit", view.source_unit},
          {"target_unit", view.target_unit},
          {"source_cut", view.source_is_cut},
          {"target_cut", view.target_is_cut}};
}

Json alternatives_json(const TrackedRun& run) {
  Json alternatives = Json::array();
  for (std::size_t k = 1; k < run.result.maps.size(); ++k) {
    Json alternative{{"folder", alternative_folder(k)}, {"fit", to_json(run.fits[k])}};
    alternative.update(map_json(run.result.maps[k]));
    alternatives.push_back(alternative);
  }
  return alternatives;
}

Json hypotheses_json(const std::vector<HypothesisSummary>& hypotheses) {
  Json json = Json::array();
  for (const HypothesisSummary& hypothesis : hypotheses)
    json.push_back({{"distortion", hypothesis.distortion},
                    {"orientation", hypothesis.orientation},
                    {"coarse_energy", hypothesis.coarse_energy}});
  return json;
}

/// Whether a quite different map fits so nearly as well that it may be the right one.
bool is_ambiguous(const TrackedResult& result) {
  // Costs that differ by less may well be those of the other map.
  constexpr double kClear = 0.9;
  return result.ambiguity > kClear;
}

Json landmarks_json(const std::vector<Match>& landmarks) {
  Json json = Json::array();
  for (const Match& landmark : landmarks) json.push_back({landmark.source, landmark.target});
  return json;
}

/// Of vertices that have a counterpart; null if there are none.
Json mean_confidence_json(const TrackedMap& map) {
  double sum = 0;
  for (std::size_t v = 0; v < map.source_to_target.size(); ++v)
    if (map.source_to_target[v].face != kNoFace) sum += map.source_confidence[v];
  const int matched = matched_vertices(map);
  return matched > 0 ? Json(sum / matched) : Json();
}

Json report_json(const TrackedRun& run, std::size_t num_matches,
                 const std::vector<StageTime>& times) {
  const TrackedResult& result = run.result;
  const int matched = matched_vertices(result.maps.front());
  Json report = report_head(run.inputs, run.options);
  report.update({{"source_vertices_matched", matched},
                 {"source_vertices_unmatched", run.inputs.source.mesh().num_vertices() - matched},
                 {"mean_confidence", mean_confidence_json(result.maps.front())},
                 {"matches", num_matches},
                 {"map", map_json(result.maps.front())},
                 {"fit", to_json(run.fits.front())},
                 {"ambiguity", result.ambiguity},
                 {"ambiguous", is_ambiguous(result)},
                 {"taken_for", view_json(result.taken_for)},
                 {"oriented", result.oriented},
                 {"contradicted_landmarks", landmarks_json(run.result.contradicted_landmarks)},
                 {"alternatives", alternatives_json(run)},
                 {"hypotheses", hypotheses_json(result.hypotheses)}});
  if (run.point_error) report["point_error_over_sqrt_area"] = *run.point_error;
  report.update(report_tail(times));
  return report;
}

}  // namespace

std::vector<std::string> tracked_files(int alternatives, bool target_to_source) {
  // There are never as many.
  constexpr int kMostAlternatives = 1000;
  std::vector<std::string> files{"correspondence.txt"};
  for (int k = 0; k <= std::min(alternatives, kMostAlternatives); ++k) {
    const std::string place = k == 0 ? "" : alternative_folder(k) + "/";
    files.push_back(place + "registered.ply");
    files.push_back(place + "source_confidence.txt");
    if (target_to_source) files.push_back(place + "target_confidence.txt");
    for (const char* map : {"source_to_target", "target_to_source"}) {
      if (map[0] == 't' && !target_to_source) continue;
      for (const char* ending : {".txt", ".bary.txt"}) files.push_back(place + map + ending);
    }
  }
  return files;
}

std::vector<std::string> doubts(const TrackedRun& run) {
  std::vector<std::string> list;
  for (const auto& [source, target] : run.result.contradicted_landmarks)
    list.push_back(
        fmt::format("the landmark {} {} contradicts the shapes: without it a far better "
                    "map is found",
                    source, target));
  if (is_ambiguous(run.result))
    list.push_back(
        fmt::format("ambiguous: another, quite different map fits nearly as well "
                    "({:.0f} %); look for a flip, and at the alternatives",
                    100 * run.result.ambiguity));
  if (!run.result.oriented && !run.options.value("allow-reflection", false))
    list.emplace_back("a surface does not tell outside from inside: the map may be mirrored");
  return list;
}

int matched_vertices(const TrackedMap& map) { return count_points(map.source_to_target); }

ResultMap result_map(const TrackedRun& run, std::size_t k) {
  const TrackedMap& map = run.result.maps[k];
  return {k == 0 ? "" : alternative_folder(k),
          nearest_vertices(run.inputs.target.mesh(), map.source_to_target),
          map.source_to_target,
          map.registered,
          map.source_confidence,
          run.target_to_source ? map.target_confidence : std::vector<float>{}};
}

Correspondence relation(const TrackedRun& run) {
  return matches(run.inputs.source.shape, run.inputs.target.shape, run.result.maps.front());
}

Json write_tracked(const ResultPlan& plan, const TrackedRun& run) {
  const std::vector<TrackedMap>& maps = run.result.maps;
  std::vector<StageTime> times = joined(run.inputs.times, run.result.times);
  ResultFolder folder(plan);
  std::size_t num_matches = 0;
  {
    const StageTimer timer(times, "writing");
    write_map(folder, run, 0);
    const Correspondence relation = results::relation(run);
    write_correspondence(folder.add("correspondence.txt"), relation);
    num_matches = relation.size();
    for (std::size_t k = 1; k < maps.size(); ++k) write_map(folder, run, k);
  }
  return folder.write_report(report_json(run, num_matches, times));
}

}  // namespace isomatch::results
