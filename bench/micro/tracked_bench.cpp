// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "shape/inspection.h"
#include "shape/prepared_shape.h"
#include "tracked/tracks/dense_map.h"
#include "tracked/tracks/finals.h"

namespace isomatch::tracked {
namespace {

Mesh creature(int vertices, int pose) {
  return synthesize({.vertices = vertices, .pose = pose}).mesh;
}

/// A pair of creatures after every stage, made anew when a benchmark of another size begins.
struct Pair {
  explicit Pair(int vertices)
      : source_shape(creature(vertices, 1), {}),
        target_shape(creature(vertices, 2), {}),
        source(make_pyramid(source_shape, {}, options.pyramid, {})),
        target(make_pyramid(target_shape, {}, options.pyramid, {})),
        judged(judged_hypotheses(source, target, options, {}).possible),
        finals(run_finals(target, judged, options, {})) {}

  Options options;
  PreparedShape source_shape, target_shape;
  Pyramid source, target;
  std::vector<Judged> judged;
  Finals finals;
};

const Pair& pair(benchmark::State& state) {
  static std::pair<int, std::unique_ptr<Pair>> latest;
  const int vertices = static_cast<int>(state.range(0));
  if (latest.first != vertices) latest = {vertices, std::make_unique<Pair>(vertices)};
  return *latest.second;
}

void inspection(benchmark::State& state) {
  const Mesh mesh = creature(static_cast<int>(state.range(0)), 1);
  for (auto _ : state) benchmark::DoNotOptimize(inspect(mesh));
}

void unit(benchmark::State& state) {
  const ExtractedSurface surface = extract_surface(creature(static_cast<int>(state.range(0)), 1));
  for (auto _ : state) benchmark::DoNotOptimize(unit_surface(surface));
}

void detail(benchmark::State& state) {
  const Pair& given = pair(state);
  for (auto _ : state) {
    // Not one that has its geodesic graph already.
    state.PauseTiming();
    const PreparedShape shape(given.source_shape.mesh(), {});
    state.ResumeTiming();
    benchmark::DoNotOptimize(make_detail(shape, *shape.surface(), given.options.pyramid, {}));
  }
}

void anchoring(benchmark::State& state) {
  const Pair& given = pair(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(anchors(*given.source.surface, given.source.detail, {}));
}

void proxy(benchmark::State& state) {
  const Pair& given = pair(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(make_proxy(given.source.detail, given.source.surface->oriented, false,
                                        given.options.pyramid.proxy, {}));
}

void basis(benchmark::State& state) {
  const Pair& given = pair(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        spectral::eigenbasis(given.source.proxy.mesh, given.options.pyramid.functions));
}

void hypotheses(benchmark::State& state) {
  const Pair& given = pair(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(judged_hypotheses(given.source, given.target, given.options, {}));
}

void refinement(benchmark::State& state) {
  const Pair& given = pair(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(run_finals(given.target, given.judged, given.options, {}));
}

void dense(benchmark::State& state) {
  const Pair& given = pair(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        dense_map(given.finals.tracks.front(), given.target, given.options, {}));
}

/// Size by size, so that each pair is prepared once.
int register_all() {
  const std::pair<const char*, void (*)(benchmark::State&)> stages[] = {
      {"inspection", inspection}, {"unit surface", unit},     {"detail", detail},
      {"anchors", anchoring},     {"proxy", proxy},           {"basis", basis},
      {"hypotheses", hypotheses}, {"refinement", refinement}, {"dense map", dense}};
  for (const int vertices : {5'000, 40'000, 200'000, 1'000'000}) {
    for (const auto& [name, stage] : stages)
      benchmark::RegisterBenchmark((std::string("tracked/") + name).c_str(), stage)
          ->Arg(vertices)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
  }
  return 0;
}

const int kRegistered = register_all();

}  // namespace
}  // namespace isomatch::tracked
