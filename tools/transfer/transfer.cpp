// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <memory>

#include "command.h"
#include "transfer/carry.h"
#include "transfer/outputs.h"

namespace isomatch::cli {
namespace {

using Carry = void (*)(const TransferJob&, const TransferArguments&);

Carry chosen_carry(const TransferArguments& arguments) {
  if (!arguments.values.empty()) return carry_values;
  if (!arguments.labels.empty()) return carry_labels;
  if (!arguments.colors.empty()) return carry_colors;
  if (!arguments.landmarks.empty()) return carry_landmarks;
  if (!arguments.skin.empty()) return carry_skin;
  if (!arguments.texture.empty()) return carry_texture;
  return carry_poses;
}

void add_cargo(CLI::App& command, TransferArguments& arguments) {
  CLI::Option_group& cargo = *command.add_option_group("What to carry", "One of these");
  cargo.add_option("--values", arguments.values, "Numbers, a line a vertex; interpolated")
      ->type_name("FILE");
  cargo.add_option("--labels", arguments.labels, "An integer a line; the corners of a face vote")
      ->type_name("FILE");
  cargo.add_option("--colors", arguments.colors, "A mesh with vertex colours; OUT is one too")
      ->type_name("PLY");
  cargo.add_option("--landmarks", arguments.landmarks, "Vertices from 0, one a line")
      ->type_name("FILE");
  cargo.add_option("--skin", arguments.skin, "BONE:WEIGHT words, a line a vertex; - for none")
      ->type_name("FILE");
  cargo.add_option("--texture", arguments.texture, "The mesh with texture coordinates")
      ->type_name("OBJ");
  cargo
      .add_option("--poses", arguments.poses,
                  "Meshes: the one that was matched, in other poses; OUT is a folder")
      ->type_name("MESH ...");
  cargo.require_option(1);
}

void add_ways(CLI::App& command, TransferArguments& arguments) {
  command.add_flag("--reverse", arguments.reverse, "Carry from the target to the source");
  command
      .add_option("--alternative", arguments.alternative,
                  "Use this alternative instead of the best map")
      ->type_name("K");
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
  command.add_option("--source", arguments.places.source, "The source mesh, if it was moved");
  command.add_option("--target", arguments.places.target, "The target mesh, if it was moved");
}

}  // namespace

void add_transfer(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<TransferArguments>();
  CLI::App& command = *app.add_subcommand("transfer", "Carry something over by a map");
  command.add_option("DIR", arguments->folder, "Folder that `isomatch match` wrote")->required();
  command.add_option("-o,--output", arguments->output, "Where to write it")
      ->type_name("OUT")
      ->required();
  add_cargo(command, *arguments);
  add_ways(command, *arguments);
  add_run_options(command, request);
  set_example(command, "isomatch transfer cats --texture cat0.obj -o cat1.obj");
  command.callback([arguments, &request] {
    request.action = [arguments](const Context& context) {
      check_transfer(*arguments);
      chosen_carry (*arguments)(load_transfer(*arguments, context), *arguments);
    };
  });
}

}  // namespace isomatch::cli
