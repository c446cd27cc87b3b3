// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "isomatch/geodesics/geodesics.h"
#include "isomatch/mesh/synth.h"
#include "shape/extraction.h"

namespace isomatch {
namespace {

struct Engine {
  const char* name;
  GeodesicOptions options;
};

const Engine kEngines[] = {{"edges", GeodesicOptions::edges()},
                           {"w20", GeodesicOptions::w20()},
                           {"w10", GeodesicOptions::w10()}};

Context one_thread() {
  Context context;
  context.threads = 1;
  return context;
}

const ExtractedSurface& creature(int vertices) {
  static std::map<int, ExtractedSurface> surfaces;
  const auto [entry, missing] = surfaces.try_emplace(vertices);
  if (missing) entry->second = extract_surface(synthesize({.vertices = vertices, .pose = 1}).mesh);
  return entry->second;
}

/// A graph and vertices of it to search from, the same in every run.
struct Workload {
  Workload(int vertices, const Engine& engine)
      : surface(creature(vertices)), graph(surface.mesh, engine.options, one_thread()) {}

  int next_vertex() { return static_cast<int>(random() % graph.num_vertices()); }

  const ExtractedSurface& surface;
  GeodesicGraph graph;
  std::mt19937 random;
};

void build(benchmark::State& state, int vertices, const Engine& engine) {
  const ExtractedSurface& surface = creature(vertices);
  double arcs = 0;
  for (auto _ : state) {
    const GeodesicGraph graph(surface.mesh, engine.options, one_thread());
    arcs = static_cast<double>(graph.num_arcs());
  }
  state.counters["arcs/vertex"] = arcs / surface.num_vertices();
}

void field(benchmark::State& state, int vertices, const Engine& engine) {
  Workload work(vertices, engine);
  GeodesicSearch search(work.graph);
  std::vector<float> distances(work.graph.num_vertices());
  for (auto _ : state) search.field(work.next_vertex(), distances);
}

void ball(benchmark::State& state, int vertices, const Engine& engine, double relative_radius) {
  Workload work(vertices, engine);
  GeodesicSearch search(work.graph);
  const auto radius = static_cast<float>(relative_radius * std::sqrt(work.surface.area));
  double reached = 0;
  for (auto _ : state)
    reached += static_cast<double>(search.ball(work.next_vertex(), radius).size());
  state.counters["vertices"] = benchmark::Counter(reached, benchmark::Counter::kAvgIterations);
}

void distance(benchmark::State& state, int vertices, const Engine& engine) {
  Workload work(vertices, engine);
  GeodesicSearch search(work.graph);
  for (auto _ : state)
    benchmark::DoNotOptimize(search.distance(work.next_vertex(), work.next_vertex()));
}

void diameter(benchmark::State& state, int vertices, const Engine& engine) {
  const Workload work(vertices, engine);
  for (auto _ : state) benchmark::DoNotOptimize(geodesic_diameter(work.graph, one_thread()));
}

const bool kRegistered = [] {
  for (const int vertices : {5'000, 170'000}) {
    for (const Engine& engine : kEngines) {
      const auto add = [&](const std::string& what, auto function, auto... arguments) {
        const std::string name =
            "geodesics/" + what + "/" + engine.name + "/" + std::to_string(vertices);
        benchmark::RegisterBenchmark(name.c_str(), function, vertices, engine, arguments...)
            ->Unit(benchmark::kMicrosecond);
      };
      add("build", build);
      add("field", field);
      add("ball_.05", ball, 0.05);
      add("ball_.2", ball, 0.2);
      add("distance", distance);
      add("diameter", diameter);
    }
  }
  return true;
}();

}  // namespace
}  // namespace isomatch
