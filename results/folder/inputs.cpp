// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/inputs.h"

#include <array>
#include <filesystem>
#include <future>
#include <utility>

#include "results/loaded_mesh.h"

namespace isomatch::results {
namespace {

MatchInput read(const std::string& path) {
  MatchInput input{path, {}, {}, {}, {}};
  input.mesh = read_mesh(path, &input.read_report);
  return input;
}

void inspect_input(MatchInput& input) {
  Inspection inspection = inspected(input.path, input.mesh);
  input.diagnosis = inspection.diagnosis;
  input.surface = std::move(*inspection.surface);
}

/// Fails now rather than after the work.
void check_truth(const TruthFiles& truth, const MatchInputs& inputs) {
  if (truth.source.empty() || truth.target.empty()) return;
  read_truth(truth, {inputs.source.mesh.num_vertices(), inputs.target.mesh.num_vertices()});
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
                        const TruthFiles& truth, const Warn& warn, const Context& context) {
  MatchInputs inputs{{}, std::filesystem::current_path().string(), {}, {}, {}};
  const std::array both{&inputs.source, &inputs.target};
  const std::array paths{source, target};
  const auto timed = [&](std::string_view stage, double begun, const auto& work) {
    context.report(begun, stage);
    const StageTimer timer(inputs.times, stage);
    for_both(context, work);
  };
  timed("reading", 0, [&](int side) { *both[side] = read(paths[side]); });
  // In one order, although both were read at once.
  for (const MatchInput* input : both)
    for (const std::string& warning : input->read_report.warnings) warn(input->path, warning);
  timed("diagnosis", kLoaded / 4, [&](int side) { inspect_input(*both[side]); });
  check_truth(truth, inputs);
  return inputs;
}

std::vector<std::vector<int>> input_vertices(const Surface& surface) {
  std::vector<std::vector<int>> vertices(surface.num_vertices());
  for (std::size_t v = 0; v < surface.surface_vertex.size(); ++v) {
    if (surface.surface_vertex[v] != kNoVertex)
      vertices[surface.surface_vertex[v]].push_back(static_cast<int>(v));
  }
  return vertices;
}

Context matching_part(const Context& context) {
  Context part = context;
  part.progress = [&context](double fraction, std::string_view stage) {
    if (context.progress) context.progress(kLoaded + fraction * (kMatched - kLoaded), stage);
  };
  return part;
}

}  // namespace isomatch::results
