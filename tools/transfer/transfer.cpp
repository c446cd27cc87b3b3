// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <memory>
#include <vector>

#include "command.h"
#include "place_options.h"
#include "program/say.h"
#include "results/files/parent_folders.h"
#include "transfer/carry.h"
#include "transfer/outputs.h"

namespace isomatch::cli {
namespace {

/// What can be carried: its option, how, and what it is called.
struct Cargo {
  const char* option;
  void (*carry)(const TransferJob&, const TransferArguments&);
  const char* name;
};

constexpr std::array<Cargo, 7> kCargos{{{"--values", carry_values, "values"},
                                        {"--labels", carry_labels, "labels"},
                                        {"--colors", carry_colors, "colours"},
                                        {"--landmarks", carry_landmarks, "landmarks"},
                                        {"--skin", carry_skin, "skinning weights"},
                                        {"--texture", carry_texture, "texture"},
                                        {"--poses", carry_poses, "poses"}}};

/// The one that the command line names. Throws unless it is one.
const Cargo& chosen_cargo(const CLI::App& command) {
  std::vector<const char*> all, given;
  const Cargo* chosen = nullptr;
  for (const Cargo& cargo : kCargos) {
    all.push_back(cargo.option);
    if (command.count(cargo.option) == 0) continue;
    given.push_back(cargo.option);
    chosen = &cargo;
  }
  if (given.empty())
    throw CLI::ValidationError(fmt::format("what to carry is missing: {}", fmt::join(all, ", ")));
  if (given.size() > 1)
    throw CLI::ValidationError(
        fmt::format("{} cannot be carried at once", fmt::join(given, " and ")));
  return *chosen;
}

constexpr const char* kCargoGroup = "What to carry, one of these";

void add_cargo(CLI::App& command, TransferArguments& arguments) {
  const auto add = [&](const char* name, auto& value, const char* help) {
    return command.add_option(name, value, help)->type_name("FILE")->group(kCargoGroup);
  };
  add("--values", arguments.values,
      "Numbers, a line a vertex, in one or more columns; interpolated");
  add("--labels", arguments.labels, "An integer a line; the corners of a face vote");
  add("--colors", arguments.colors, "A .ply mesh with vertex colours; OUT is one too");
  add("--landmarks", arguments.landmarks,
      "Vertices from 0, one a line; OUT is a .txt, .map, .vts, .bary.txt or .npz file");
  add("--skin", arguments.skin, "BONE:WEIGHT words, a line a vertex; - for none");
  add("--texture", arguments.texture,
      "The mesh with texture coordinates, a .obj file; OUT is one too");
  add("--poses", arguments.poses,
      "Meshes: the one that was matched, in other poses; OUT is a folder");
}

void add_ways(CLI::App& command, TransferArguments& arguments) {
  command.add_flag("--reverse", arguments.reverse, "Carry from the target to the source");
  command
      .add_option("--alternative", arguments.alternative,
                  "Use this alternative instead of the best map")
      ->type_name("N");
  command.add_option("--image", arguments.image, "The image of a texture whose file names none")
      ->type_name("FILE")
      ->needs("--texture");
  command
      .add_flag("--keep-faces", arguments.keep_faces,
                "Do not cut faces where a seam of the texture crosses them")
      ->needs("--texture");
  command
      .add_flag("--same-rest-pose", arguments.same_rest_pose,
                "Both meshes are in the same pose: carry how the frames differ from it")
      ->needs("--poses");
  add_places(command, arguments.places);
}

void run_transfer(const TransferArguments& arguments, const Cargo& cargo, const Context& context) {
  const results::ParentFolders parents(arguments.output);
  check_transfer(arguments);
  cargo.carry(load_transfer(arguments, context), arguments);
  if (!arguments.quiet) say("{} written to {}", cargo.name, arguments.output);
}

}  // namespace

void add_transfer(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<TransferArguments>();
  CLI::App& command = *app.add_subcommand("transfer", "Carry something over by a map");
  command.add_option("DIR", arguments->folder, "Folder that `isomatch match` wrote")->required();
  command.add_option("-o,--output", arguments->output, "Where to write it, a file or a folder")
      ->type_name("OUT")
      ->required();
  add_cargo(command, *arguments);
  add_ways(command, *arguments);
  add_run_options(command, request);
  set_example(command, "isomatch transfer cats --texture cat0.obj -o cat1.obj", "transfer.md");
  command.callback([arguments, &command, &request] {
    arguments->quiet = request.quiet;
    request.action = [arguments, &cargo = chosen_cargo(command)](const Context& context) {
      run_transfer(*arguments, cargo, context);
    };
  });
}

}  // namespace isomatch::cli
