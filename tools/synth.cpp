// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/synth.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>

#include "command.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "program/say.h"
#include "results/files/outputs.h"
#include "results/files/parent_folders.h"

namespace isomatch::cli {
namespace {

struct SynthArguments {
  SynthOptions options;
  std::string output;
  bool quiet = false;
};

void run_synth(const SynthArguments& arguments, const Context& context) {
  const std::string& path = arguments.output;
  const auto beside = [&](const char* ending) {
    return std::filesystem::path(path).replace_extension(ending).string();
  };
  const std::string truth = beside(".vts"), symmetric_truth = beside(".sym.vts");
  const results::ParentFolders parents(path);
  check_mesh_output(path);
  for (const std::string& file : {truth, symmetric_truth})
    results::check_companion_output(file, path, {});
  const SynthShape shape = synthesize(arguments.options, context);
  write_mesh(path, shape.mesh);
  write_ground_truth(truth, shape.ground_truth);
  write_ground_truth(symmetric_truth, shape.symmetric_ground_truth);
  if (!arguments.quiet)
    say("mesh of {} vertices written to {}, its ground truth to {} and {}",
        shape.mesh.num_vertices(), path, truth, symmetric_truth);
}

}  // namespace

void add_synth(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<SynthArguments>();
  SynthOptions& options = arguments->options;
  CLI::App& command = *app.add_subcommand("synth", "Make a mesh with known correspondence");
  command
      .add_option("--shape", options.shape,
                  fmt::format("What to make, one of: {}", fmt::join(synth_shapes(), ", ")))
      ->type_name("NAME")
      ->capture_default_str();
  command
      .add_option("--vertices", options.vertices,
                  "Number of vertices, met within 2 % before parts are removed")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--pose", options.pose, "0 is the rest pose, every other number another one")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Decides the shape's proportions")
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--cut", options.cut,
                  "Share of the area that is removed, 0 to .95: what lies beyond a plane of random "
                  "direction, another one for each seed and pose")
      ->type_name("SHARE")
      ->capture_default_str();
  command
      .add_option("--holes", options.holes,
                  "Round holes, at random places that seed and pose decide")
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option(
          "-o,--output", arguments->output,
          "Mesh file (.off .obj .ply .glb .gltf .mat); the ground truth goes beside it, as .vts "
          "and .sym.vts, with 0 for points that were removed")
      ->type_name("FILE")
      ->required();
  add_run_options(command, request);
  set_example(command, "isomatch synth --vertices 20000 --pose 3 --seed 7 -o creature3.off",
              "tutorial.md");
  command.callback([arguments, &request] {
    arguments->quiet = request.quiet;
    request.action = [arguments](const Context& context) { run_synth(*arguments, context); };
  });
}

}  // namespace isomatch::cli
