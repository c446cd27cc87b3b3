// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/inputs.h"

#include <array>
#include <filesystem>
#include <future>
#include <utility>

#include "isomatch/error.h"
#include "load.h"

namespace isomatch::cli {
namespace {

/// Fails now rather than after the work if the results will have no place.
void check_folder(const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path path = fs::absolute(folder).lexically_normal();
  const fs::path parent =
      path.has_filename() ? path.parent_path() : path.parent_path().parent_path();
  if (fs::exists(path)) {
    if (!fs::is_directory(path)) throw BadFile(folder, "is not a folder");
  } else if (!fs::is_directory(parent)) {
    throw BadFile(folder, "cannot be created: there is no folder " + parent.string());
  }
}

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

/// Does `work` for the source and the target, whose errors come second.
template <class Work>
void for_both(const Context& context, const Work& work) {
  const auto policy = context.threads > 1 ? std::launch::async : std::launch::deferred;
  std::future<void> target = std::async(policy, [&] { work(1); });
  work(0);
  target.get();
}

}  // namespace

MatchInputs load_inputs(const MatchArguments& arguments, const Context& context) {
  check_folder(arguments.folder);
  MatchInputs inputs{arguments.words, std::filesystem::current_path().string(), {}, {}, {}};
  const std::array both{&inputs.source, &inputs.target};
  const std::array paths{arguments.source, arguments.target};
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

}  // namespace isomatch::cli
