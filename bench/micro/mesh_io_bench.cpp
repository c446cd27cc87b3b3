// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <random>
#include <string>

#include "isomatch/io/mesh_io.h"

namespace isomatch {
namespace {

// Vertices along each direction of the torus.
constexpr int k164Thousand = 405;
constexpr int kMillion = 1000;

/// A torus of side^2 vertices and twice as many faces, with coordinates of full precision.
Mesh torus(int side) {
  Mesh mesh;
  const double step = 2 * std::numbers::pi / side;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double radius = 1 + 0.4 * std::cos(step * j);
      mesh.vertices.emplace_back(radius * std::cos(step * i), radius * std::sin(step * i),
                                 0.4 * std::sin(step * j));
      const int right = (i + 1) % side, up = (j + 1) % side;
      const int a = i * side + j, b = right * side + j, c = right * side + up, d = i * side + up;
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  }
  return mesh;
}

/// A name for a temporary file, which is removed in the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& ending)
      : path_(std::filesystem::temp_directory_path() /
              ("isomatch-bench-" + std::to_string(std::random_device()()) + ending)) {}
  ~TemporaryFile() { std::filesystem::remove(path_); }

  std::string path() const { return path_.string(); }
  std::int64_t size() const { return static_cast<std::int64_t>(std::filesystem::file_size(path_)); }

 private:
  std::filesystem::path path_;
};

/// The benchmarks' argument is the side of the torus.
void mesh_read(benchmark::State& state, const std::string& ending) {
  const TemporaryFile file(ending);
  write_mesh(file.path(), torus(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh(file.path()));
  state.SetBytesProcessed(state.iterations() * file.size());
}

void mesh_write(benchmark::State& state, const std::string& ending) {
  const TemporaryFile file(ending);
  const Mesh mesh = torus(static_cast<int>(state.range(0)));
  for (auto _ : state) write_mesh(file.path(), mesh);
  state.SetBytesProcessed(state.iterations() * file.size());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(k164Thousand)->Arg(kMillion)->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(mesh_read, off, ".off")->Apply(sizes);
BENCHMARK_CAPTURE(mesh_read, obj, ".obj")->Apply(sizes);
BENCHMARK_CAPTURE(mesh_read, ply, ".ply")->Apply(sizes);
BENCHMARK_CAPTURE(mesh_write, off, ".off")->Apply(sizes);
BENCHMARK_CAPTURE(mesh_write, obj, ".obj")->Apply(sizes);
BENCHMARK_CAPTURE(mesh_write, ply, ".ply")->Apply(sizes);

}  // namespace
}  // namespace isomatch
