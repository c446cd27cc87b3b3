// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "command.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/io/model_io.h"
#include "load.h"
#include "map_input.h"
#include "program/say.h"
#include "results/drawing/result_model.h"
#include "results/files/parent_folders.h"
#include "results/folder/result.h"

namespace isomatch::cli {
namespace {

struct ConvertArguments {
  std::string input, output;
  results::MeshPlaces places;
  MeshReadOptions reading;
  std::size_t alternative = 0;
  bool one_based = false, write_one_based = false, quiet = false;

  Numbering output_numbering() const {
    return write_one_based ? Numbering::kFromOne : Numbering::kFromZero;
  }
};

void convert_result(const ConvertArguments& arguments) {
  const bool to_map = is_map_file_name(arguments.output);
  const results::MatchResult result = results::load_result(arguments.input, arguments.places);
  const results::ResultMap& map = results::chosen_map(result, arguments.alternative);
  if (to_map)
    write_map(arguments.output, {map.source_to_target, map.points}, arguments.output_numbering());
  else
    write_model(arguments.output, results::result_model(result, map));
}

/// Adds the form that the output has, if it is another one than the input's.
void add_missing_form(MapContent& map, const ConvertArguments& arguments,
                      const std::optional<Mesh>& target) {
  const bool to_points = is_point_map_file_name(arguments.output);
  // Arrays have room for both forms.
  const bool to_arrays = !to_points && target && arguments.output.ends_with(".npz");
  const bool needs_points = map.points.empty() && (to_points || to_arrays);
  const bool needs_vertices = map.source_to_target.empty() && !to_points &&
                              (to_arrays || !arguments.output.ends_with(".npz"));
  if (!needs_points && !needs_vertices) return;
  if (!target)
    throw InvalidInput("from vertices to points on triangles or back needs the mesh: --target");
  if (needs_points) map.points = corner_points(*target, map.source_to_target);
  if (needs_vertices) map.source_to_target = nearest_vertices(*target, map.points);
}

void convert_map(const ConvertArguments& arguments) {
  MapChecks checks;
  std::optional<Mesh> target;
  if (!arguments.places.source.empty())
    checks.source_vertices = load_mesh(arguments.places.source).num_vertices();
  if (!arguments.places.target.empty()) {
    target = load_mesh(arguments.places.target);
    checks.target_vertices = target->num_vertices();
    checks.target_faces = target->num_faces();
  }
  MapReadReport report;
  MapContent map = read_map(arguments.input, checks, told_numbering(arguments.one_based), &report);
  if (const auto note = numbering_note(arguments.input, report, arguments.one_based))
    arguments.quiet ? warn(*note) : say("{}", *note);
  add_missing_form(map, arguments, target);
  write_map(arguments.output, map, arguments.output_numbering());
}

/// What is told and would change nothing is a mistake.
void refuse_idle_options(const ConvertArguments& arguments) {
  const bool is_result = std::filesystem::is_directory(arguments.input);
  const bool is_map = !is_result && is_map_file_name(arguments.input);
  if (arguments.one_based && !is_map) throw InvalidInput("--one-based is for maps");
  if (arguments.write_one_based && !is_map_file_name(arguments.output))
    throw InvalidInput("--write-one-based is for maps");
  if (arguments.alternative != 0 && !is_result) throw InvalidInput("--alternative is for results");
  if (arguments.reading.mesh && (is_map || is_result)) throw InvalidInput("--mesh is for meshes");
  const results::MeshPlaces& places = arguments.places;
  if (!(places.source.empty() && places.target.empty()) && !is_result && !is_map)
    throw InvalidInput("--source and --target are for maps and results");
}

/// Fails now rather than after the work.
void check_convert(const ConvertArguments& arguments) {
  refuse_idle_options(arguments);
  const bool is_result = std::filesystem::is_directory(arguments.input);
  // Reading says what is wrong with another input.
  if (!is_result && !is_map_file_name(arguments.input) && !is_mesh_file_name(arguments.input))
    return;
  const bool to_map =
      is_map_file_name(arguments.output) && (is_result || is_map_file_name(arguments.input));
  to_map ? check_map_output(arguments.output) : check_mesh_output(arguments.output);
  results::InputFiles inputs = is_result ? results::result_inputs(arguments.input, arguments.places)
                                         : results::InputFiles({arguments.input});
  inputs.add(arguments.places.source);
  inputs.add(arguments.places.target);
  inputs.refuse(arguments.output);
}

void run_convert(const ConvertArguments& arguments) {
  const results::ParentFolders parents(arguments.output);
  check_convert(arguments);
  if (std::filesystem::is_directory(arguments.input))
    convert_result(arguments);
  else if (is_map_file_name(arguments.input))
    convert_map(arguments);
  else
    write_model(arguments.output, load_model(arguments.input, arguments.reading));
  if (!arguments.quiet) say("written to {}", arguments.output);
}

void add_map_options(CLI::App& command, ConvertArguments& arguments) {
  command.add_flag("--one-based", arguments.one_based,
                   "IN, a map, numbers from one; without this from zero unless that cannot be");
  command.add_flag("--write-one-based", arguments.write_one_based,
                   "Number from one in OUT, a map; .vts always does, .npz never");
  command
      .add_option("--source", arguments.places.source,
                  "Of a map, to check it; of a result, if the mesh was moved")
      ->type_name("FILE");
  command
      .add_option("--target", arguments.places.target,
                  "Of a map, to check it or to turn vertices into points on triangles or back; "
                  "of a result, if the mesh was moved")
      ->type_name("FILE");
  command
      .add_option("--alternative", arguments.alternative,
                  "Use this alternative of a result instead of the best map")
      ->type_name("N");
}

}  // namespace

void add_convert(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<ConvertArguments>();
  CLI::App& command =
      *app.add_subcommand("convert", "Write a mesh, a map or a result in another format");
  command
      .add_option("IN", arguments->input,
                  "Mesh (.off .obj .ply .stl .glb .gltf .mat), map (.txt .map .vts .bary.txt .npz) "
                  "or folder that `isomatch match` wrote")
      ->required();
  command
      .add_option(
          "OUT", arguments->output,
          "Mesh (.off .obj .ply .glb .gltf .mat) or map (.txt .map .vts .bary.txt .npz); of "
          "a folder the source with colours and both poses, or the map")
      ->required();
  add_mesh_option(command, arguments->reading);
  add_map_options(command, *arguments);
  add_quiet_option(command, request);
  set_example(command,
              "isomatch convert cat0.mat cat0.off\n"
              "  isomatch convert cats cats.glb\n"
              "  isomatch convert cats cats.npz",
              "formats.md");
  command.callback([arguments, &request] {
    arguments->quiet = request.quiet;
    request.action = [arguments](const Context&) { run_convert(*arguments); };
  });
}

}  // namespace isomatch::cli
