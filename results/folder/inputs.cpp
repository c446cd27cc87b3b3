// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/inputs.h"

#include <array>
#include <filesystem>
#include <future>
#include <optional>
#include <utility>

#include "results/loaded_mesh.h"

namespace isomatch::results {
namespace {

/// Fails now rather than after the work.
void check_truth(const TruthFiles& truth, const MatchInputs& inputs) {
  if (truth.source.empty() || truth.target.empty()) return;
  read_truth(truth, {inputs.source.mesh().num_vertices(), inputs.target.mesh().num_vertices()});
}

/// Does `work` for the source and the target, whose errors come second.
template <class Work>
void for_both(const Context& context, const Work& work) {
  const auto policy = context.threads > 1 ? std::launch::async : std::launch::deferred;
  std::future<void> target = std::async(policy, [&] { work(1); });
  work(0);
  target.get();
}

}  // namespace

MatchInputs load_inputs(const std::string& source, const std::string& target,
                        const GeodesicOptions& geodesics, const TruthFiles& truth, const Warn& warn,
                        const Context& context) {
  const std::array paths{source, target};
  std::array<Mesh, 2> meshes;
  std::array<MeshReadReport, 2> reports;
  std::array<std::optional<Shape>, 2> shapes;
  std::vector<StageTime> times;
  const auto timed = [&](std::string_view stage, double begun, const auto& work) {
    context.report(begun, stage);
    const StageTimer timer(times, stage);
    for_both(context, work);
  };
  timed("reading", 0, [&](int side) { meshes[side] = read_mesh(paths[side], &reports[side]); });
  // In one order, although both were read at once.
  for (const int side : {0, 1})
    for (const std::string& warning : reports[side].warnings) warn(paths[side], warning);
  timed("diagnosis", kLoaded / 4, [&](int side) {
    shapes[side] = shape_of(paths[side], std::move(meshes[side]), geodesics);
  });
  MatchInputs inputs{{},
                     std::filesystem::current_path().string(),
                     {source, std::move(reports[0]), *shapes[0]},
                     {target, std::move(reports[1]), *shapes[1]},
                     std::move(times)};
  check_truth(truth, inputs);
  return inputs;
}

Context matching_part(const Context& context) {
  Context part = context;
  part.progress = [&context](double fraction, std::string_view stage) {
    if (context.progress) context.progress(kLoaded + fraction * (kMatched - kLoaded), stage);
  };
  return part;
}

}  // namespace isomatch::results
