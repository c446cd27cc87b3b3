// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "bench/measure.h"

#include <algorithm>
#include <chrono>

#include "bench/child.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/stage_times.h"
#include "results/loaded_mesh.h"

namespace isomatch::baselines {
namespace {

using results::Json;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Json shape_json(const std::string& file, const Shape& shape) {
  return {{"file", file},
          {"vertices", shape.num_vertices()},
          {"surface_vertices", shape.num_surface_vertices()},
          {"area", shape.area()},
          {"max_geodesic", shape.max_geodesic()}};
}

/// Shares of the errors that are at most 0, .005, ..., .25.
Json cumulative(const std::vector<double>& errors) {
  constexpr int kSteps = 50;
  constexpr double kStep = 0.005;
  Json shares = Json::array();
  for (int i = 0; i <= kSteps; ++i) {
    const auto below = std::ranges::upper_bound(errors, i * kStep) - errors.begin();
    shares.push_back(
        errors.empty() ? 0.0 : static_cast<double>(below) / static_cast<double>(errors.size()));
  }
  return shares;
}

Json map_json(const results::Evaluation& evaluation) {
  Json json = to_json(evaluation);
  const auto add_curve = [&](const char* name,
                             const std::optional<results::TruthEvaluation>& truth) {
    if (!truth) return;
    json[name]["cumulative"] = cumulative(truth->template_errors.errors);
    if (truth->point_errors)
      json[name]["point_cumulative"] = cumulative(truth->point_errors->errors);
  };
  add_curve("ground_truth", evaluation.truth);
  add_curve("symmetric_ground_truth", evaluation.symmetric_truth);
  if (const auto& truth = evaluation.true_map)
    json["ground_truth_map"]["cumulative"] = cumulative(truth->match_errors.over_sqrt_area.errors);
  return json;
}

Json levels_json(const std::vector<LevelSummary>& levels) {
  Json json = Json::array();
  for (const LevelSummary& level : levels)
    json.push_back({{"source_bases", level.source_bases},
                    {"target_bases", level.target_bases},
                    {"many_to_one_d_iso", level.many_to_one},
                    {"d_iso", level.many_to_many}});
  return json;
}

void write_map(const std::string& stem, const Shape& source, const NamedMap& map) {
  VertexMap vertices(source.num_vertices(), kUnmatched);
  for (const auto& [s, t] : map.matches) vertices[s] = t;
  isomatch::write_map(stem + ".txt", {.source_to_target = vertices});
  if (map.points) isomatch::write_map(stem + ".bary.txt", {.points = *map.points});
}

/// A pair in memory, and the time it took to make shapes of meshes.
struct Prepared {
  Shape source, target;
  double seconds;
};

Prepared prepare(const Pair& pair, const Context& context) {
  Mesh source = read_mesh(pair.source), target = read_mesh(pair.target);
  const auto start = std::chrono::steady_clock::now();
  Shape source_shape = results::shape_of(pair.source, std::move(source));
  Shape target_shape = results::shape_of(pair.target, std::move(target));
  for (const Shape* shape : {&source_shape, &target_shape}) shape->max_geodesic(context);
  return {std::move(source_shape), std::move(target_shape), seconds_since(start)};
}

Json maps_json(const Prepared& prepared, const MethodResult& result, const Pair& pair,
               const MeasureOptions& options, const Context& context) {
  Json maps = Json::object();
  for (const NamedMap& map : result.maps) {
    if (std::ranges::find(options.maps, map.name) == options.maps.end()) continue;
    maps[map.name] = map_json(evaluate(prepared.source, prepared.target, {map.matches, map.points},
                                       pair.truth, options.evaluation, context));
  }
  return maps;
}

Json measure_method(const Method& method, const Prepared& prepared, const Pair& pair,
                    const MeasureOptions& options, const Context& context) {
  const double loaded = peak_memory_mib();
  const auto start = std::chrono::steady_clock::now();
  const MethodResult result = method.run(prepared.source, prepared.target, context);
  const double matching = seconds_since(start);
  Json json{{"seconds", prepared.seconds + matching},
            {"preparation_seconds", prepared.seconds},
            {"peak_memory_mib", peak_memory_mib()},
            {"loaded_memory_mib", loaded}};
  for (const StageTime& time : result.times) json["stages"][time.stage] = time.seconds;
  if (!options.map_folder.empty())
    write_map(options.map_folder + "/" + method.name, prepared.source, result.maps.front());
  json["maps"] = maps_json(prepared, result, pair, options, context);
  if (!result.levels.empty()) json["levels"] = levels_json(result.levels);
  return json;
}

}  // namespace

Json measure(const Method& method, const Pair& pair, const MeasureOptions& options,
             const Context& context) {
  const Prepared prepared = prepare(pair, context);
  Json json{{"source", shape_json(pair.source, prepared.source)},
            {"target", shape_json(pair.target, prepared.target)}};
  try {
    json["result"] = measure_method(method, prepared, pair, options, context);
  } catch (const BadFile&) {
    throw;
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    json["result"] = {{"failure", error.what()}};
  }
  return json;
}

}  // namespace isomatch::baselines
