// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "command.h"
#include "isomatch/error.h"
#include "isomatch/io/model_io.h"
#include "load.h"
#include "place_options.h"
#include "program/say.h"
#include "results/drawing/drawable.h"
#include "results/drawing/pair_confidence.h"
#include "results/drawing/pair_view.h"
#include "results/files/materials.h"
#include "results/files/outputs.h"
#include "results/files/parent_folders.h"
#include "results/folder/result.h"
#include "results/picture/pair.h"
#include "results/picture/position_colors.h"
#include "results/picture/viridis.h"

namespace isomatch::cli {
namespace {

using picture::Color;

struct RenderArguments {
  std::string folder, output, background = "white";
  results::MeshPlaces places;
  results::ViewOptions view;
  std::string color = "map";
  std::size_t alternative = 0;
  /// Files of the source and the target.
  std::vector<std::string> textures;
  int width = 1600;
  bool quiet = false;
};

struct PairColors {
  std::vector<Color> source, target;
};

std::vector<Color> target_colors(const results::MatchResult& result,
                                 const std::vector<bool>& matched,
                                 const picture::PositionColors& color) {
  std::vector<Color> colors;
  for (int v = 0; v < result.target.num_vertices(); ++v)
    colors.push_back(matched[v] ? color(result.target.vertices[v]) : picture::kUnmatchedColor);
  return colors;
}

std::vector<Color> scale_colors(const std::vector<float>& shares) {
  std::vector<Color> colors;
  for (float share : shares)
    colors.push_back(std::isnan(share) ? picture::kUnmatchedColor : picture::viridis(share));
  return colors;
}

PairColors confidence_colors(const results::MatchResult& result, const results::ResultMap& map,
                             const std::vector<bool>& matched) {
  const std::optional<results::PairConfidence> confidence =
      results::pair_confidence(result, map, matched);
  if (!confidence)
    throw BadFile(result.folder,
                  "has no source_confidence.txt, which only the tracked method writes");
  return {scale_colors(confidence->source), scale_colors(confidence->target)};
}

PairColors pair_colors(const results::MatchResult& result, const results::ResultMap& map,
                       const results::PairView& view, const std::string& kind) {
  const std::vector<bool> matched =
      results::matched_targets(result.target, results::load_relation(result));
  if (kind == "confidence") return confidence_colors(result, map, matched);
  const picture::PositionColors color(view.target, result.target.vertices);
  return {results::source_colors(result, map, color), target_colors(result, matched, color)};
}

Color background_color(const std::string& name) {
  return name == "black" ? Color(0.01F, 0.01F, 0.012F) : Color(1, 1, 1);
}

/// Fails now rather than after the work.
void check_render(const RenderArguments& arguments) {
  results::check_ending(arguments.output, {".png"});
  results::InputFiles inputs = results::result_inputs(arguments.folder, arguments.places);
  for (const std::string& texture : arguments.textures) inputs.add(texture);
  results::check_output(arguments.output, inputs);
}

/// A file's mesh, which begins with the vertices of a mesh that was matched, and what it shows.
struct Painted {
  Mesh mesh;
  picture::TexturePaint paint;
};

/// Equal, also where coordinates are not numbers.
bool is_same_place(const Point& a, const Point& b) {
  return ((a.array() == b.array()) || (a.array().isNaN() && b.array().isNaN())).all();
}

Painted load_painted(const std::string& path, const Mesh& matched) {
  TexturedMesh textured = load_textured_mesh(path);
  const auto same =
      std::ranges::mismatch(matched.vertices, textured.mesh.vertices, is_same_place).in1;
  if (same != matched.vertices.end())
    throw BadFile(path, "does not begin with the vertices of the mesh that was matched");
  results::make_drawable(textured.mesh);
  Painted painted{std::move(textured.mesh), {std::move(textured.texture), {}}};
  for (const std::string& image :
       results::material_images(path, painted.paint.texture.materials, warn_of))
    painted.paint.images.push_back(image.empty() ? picture::Image{} : picture::read_image(image));
  return painted;
}

picture::Image draw_textures(const results::MatchResult& result, const results::PairView& view,
                             const RenderArguments& arguments) {
  Painted source = load_painted(arguments.textures[0], result.source);
  Painted target = load_painted(arguments.textures[1], result.target);
  return picture::draw_pair({source.mesh, std::move(source.paint), view.source},
                            {target.mesh, std::move(target.paint), view.target}, arguments.width,
                            background_color(arguments.background));
}

picture::Image draw_map(const results::MatchResult& result, const results::ResultMap& map,
                        const results::PairView& view, const RenderArguments& arguments) {
  PairColors colors = pair_colors(result, map, view, arguments.color);
  return picture::draw_pair({result.source, std::move(colors.source), view.source},
                            {result.target, std::move(colors.target), view.target}, arguments.width,
                            background_color(arguments.background));
}

void run_render(const RenderArguments& arguments) {
  const results::ParentFolders parents(arguments.output);
  check_render(arguments);
  const results::MatchResult result = results::load_result(arguments.folder, arguments.places);
  results::MatchResult drawn = result;
  results::make_drawable(drawn);
  const results::ResultMap& map = results::chosen_map(drawn, arguments.alternative);
  const results::PairView view = results::choose_pair_view(drawn, map, arguments.view);
  const picture::Image image = arguments.textures.empty() ? draw_map(drawn, map, view, arguments)
                                                          : draw_textures(result, view, arguments);
  write_png(arguments.output, image);
  if (!arguments.quiet)
    say("picture of {} x {} pixels written to {}", image.width, image.height, arguments.output);
}

void add_view_options(CLI::App& command, RenderArguments& arguments) {
  command.add_option("--width", arguments.width, "Pixels from left to right")
      ->check(CLI::Range(100, 20000))
      ->capture_default_str();
  command
      .add_option("--up", arguments.view.up, "What is up in the source's file; guessed by default")
      ->check(CLI::IsMember({"x", "-x", "y", "-y", "z", "-z"}));
  command
      .add_option("--turn", arguments.view.turn,
                  "Degrees to turn the shapes by, from where their largest side shows")
      ->capture_default_str();
  command.add_option("--background", arguments.background, "What is behind the shapes")
      ->check(CLI::IsMember({"white", "black"}))
      ->capture_default_str();
}

}  // namespace

void add_render(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<RenderArguments>();
  CLI::App& command =
      *app.add_subcommand("render", "Draw a result: colours carried by the map, or its confidence");
  command.add_option("DIR", arguments->folder, "Folder that `isomatch match` wrote")->required();
  command.add_option("-o,--output", arguments->output, "Picture, a .png file")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--alternative", arguments->alternative,
                  "Draw this alternative instead of the best map")
      ->type_name("N");
  CLI::Option* const color =
      command
          .add_option(
              "--color", arguments->color,
              "What colours show: the target's places, carried over by the map, or how sure "
              "each point is, from violet, not at all, to yellow; unmatched is grey")
          ->check(CLI::IsMember({"map", "confidence"}))
          ->capture_default_str();
  command
      .add_option(
          "--textures", arguments->textures,
          "Draw these textures instead: SOURCE, and the TARGET that `transfer` made; PNG or "
          "JPEG images, a checkerboard without")
      ->type_name("FILE")
      ->expected(2)
      ->excludes(color);
  add_places(command, arguments->places);
  add_view_options(command, *arguments);
  add_quiet_option(command, request);
  set_example(command, "isomatch render cats -o cats.png", "tutorial.md");
  command.callback([arguments, &request] {
    arguments->quiet = request.quiet;
    request.action = [arguments](const Context&) { run_render(*arguments); };
  });
}

}  // namespace isomatch::cli
