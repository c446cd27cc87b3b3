// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/group/group.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.h"
#include "isomatch/error.h"
#include "isomatch/group/shape_model.h"
#include "match/tracked_options.h"
#include "memory_option.h"
#include "program/partly_failed.h"
#include "program/say.h"
#include "results/files/outputs.h"
#include "results/files/parent_folders.h"
#include "results/folder/inputs.h"
#include "results/group/collection.h"
#include "results/group/group_run.h"
#include "results/group/run_output.h"
#include "results/group/unmatched.h"
#include "results/page/filled_page.h"
#include "results/page/group_run_page.h"

namespace isomatch::cli {
namespace {

struct GroupCommand {
  std::vector<std::string> places, words;
  std::string folder, template_name;
  GroupOptions options;
  ShapeModelOptions model;
  int points = 0;
  double memory_gib = 2;
  bool all_maps = false, report = false, quiet = false;
};

/// The file of the shape of that name, or the file itself; empty if none is named.
std::string template_file(const std::string& name, const std::vector<std::string>& files) {
  if (name.empty()) return {};
  const auto named = std::ranges::find(files, name, results::shape_name);
  if (named != files.end()) return *named;
  if (std::ranges::count(files, name) > 0) return name;
  throw InvalidInput(fmt::format("--template: {} is none of the shapes", name));
}

/// Where in the collection that file is; -1 if it has no name.
int place_of(const std::string& file, const results::Collection& collection) {
  if (file.empty()) return -1;
  const auto found = std::ranges::find(collection.paths, file);
  if (found == collection.paths.end()) throw BadFile(file, "is the template, but cannot be used");
  return static_cast<int>(found - collection.paths.begin());
}

/// All but so many, which were told of.
void tell_left_out(const results::Collection& collection, std::size_t told) {
  for (std::size_t k = told; k < collection.left_out.size(); ++k)
    say("left out: {}", collection.left_out[k].reason);
}

results::Collection collected(const GroupCommand& group, const std::vector<std::string>& files,
                              const Context& context) {
  results::Collection collection = results::read_collection(
      files,
      [&](const std::string& path, std::string_view warning) {
        if (!group.quiet) say("{}: {}", path, warning);
      },
      context);
  tell_left_out(collection, 0);
  if (collection.shapes.size() < 2)
    throw InvalidInput(fmt::format("a group needs two shapes at least; {} of {} can be used",
                                   collection.shapes.size(), files.size()));
  return collection;
}

void tell(const results::GroupRun& run, const std::string& folder) {
  const auto graded = [&](FitGrade grade) {
    return std::ranges::count(run.result.members, grade,
                              [](const GroupMember& member) { return member.fit.grade; });
  };
  const auto replaced = std::ranges::count_if(
      run.result.pairs, [](const GroupPair& pair) { return pair.use != PairUse::kAgrees; });
  say("{} shapes, template {}: {} good, {} doubtful, {} poor", run.collection.names.size(),
      run.collection.names[run.result.template_shape], graded(FitGrade::kGood),
      graded(FitGrade::kDoubtful), graded(FitGrade::kPoor));
  say("{} {} matched, of which {} disagree with the others", run.result.pairs.size(),
      run.result.pairs.size() == 1 ? "pair" : "pairs", replaced);
  say("written to {}", folder);
}

void run_group(const GroupCommand& group, const Context& context) {
  if (group.report) results::check_page_available();
  results::check_folder_name(group.folder);
  const std::vector<std::string> files = results::collected_files(group.places);
  const std::string template_path = template_file(group.template_name, files);
  const results::ParentFolders parents(group.folder);
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(results::shape_name(file));
  results::ResultPlan plan{group.folder, results::group_run_files(names, group.all_maps),
                           results::InputFiles(files)};
  plan.files.emplace_back(results::kGroupPage);
  results::check_plan(plan);
  context.report(0, "reading");
  results::GroupRun run{
      group.words,
      std::filesystem::current_path().string(),
      results::group_options_json(group.options, group.template_name, group.points, group.model),
      collected(group, files, context),
      {}};
  GroupOptions options = group.options;
  options.template_shape = place_of(template_path, run.collection);
  options.memory = bytes_of_gib(group.memory_gib);
  run.all_maps = group.all_maps;
  run.result = match_group(run.collection.shapes, options, results::matching_part(context));
  const std::size_t unread = run.collection.left_out.size();
  results::leave_out_unmatched(run);
  tell_left_out(run.collection, unread);
  context.report(results::kMatched, "model");
  const auto output_at = [&](int points) {
    return results::group_output(run, results::spread_vertices(run, points, context), group.model);
  };
  const results::GroupOutput output = output_at(group.points);
  const results::Json report = results::write_group_run(plan, run, output);
  if (group.report)
    results::write_group_page(group.folder, report, run, group.points == 0 ? output : output_at(0));
  if (!group.quiet) tell(run, group.folder);
  if (const std::size_t left_out = run.collection.left_out.size(); left_out > 0)
    throw PartlyFailed(fmt::format("{} of {} shapes were left out", left_out, files.size()));
}

std::string at_least_minus_one(const std::string& text) {
  int value = 0;
  const bool fits = CLI::detail::lexical_cast(text, value) && value >= -1;
  return fits ? std::string() : "expected -1, 0 or more, not " + text;
}

void add_output_options(CLI::App& command, GroupCommand& group) {
  command
      .add_option("-o,--output", group.folder,
                  "Folder for the results: points, meshes, maps, mean and modes")
      ->type_name("DIR")
      ->required();
  command
      .add_option("--points", group.points,
                  "Evenly spread points on each shape; 0 for all vertices of the template")
      ->type_name("P")
      ->check([](const std::string& text) {
        int points = 0;
        const bool fits = CLI::detail::lexical_cast(text, points) && (points == 0 || points >= 3);
        return fits ? std::string() : "expected 0, or 3 and more, not " + text;
      })
      ->capture_default_str();
  command.add_option("--modes", group.model.modes, "Principal modes at most; -1 for all")
      ->type_name("K")
      ->check(at_least_minus_one)
      ->capture_default_str();
  command.add_flag("--keep-size", group.model.keep_size,
                   "Size is a part of shape: align by moving and turning only");
  command.add_flag("--all-maps", group.all_maps, "Write the maps between all shapes as well");
  command.add_flag("--report", group.report,
                   "Write group.html as well, a page that shows the collection");
}

}  // namespace

void add_group(CLI::App& app, Request& request) {
  const auto group = std::make_shared<GroupCommand>();
  CLI::App& command =
      *app.add_subcommand("group", "Match a collection of shapes: the same points on all of them");
  command.add_option("SHAPES", group->places, "Meshes, and folders of meshes")->required();
  add_output_options(command, *group);
  command
      .add_option("--template", group->template_name,
                  "Name of the shape whose vertices are followed; else the one that is nearest to "
                  "all others")
      ->type_name("NAME");
  command
      .add_option(
          "--neighbours", group->options.neighbours,
          "Shapes most like it that each shape is matched with besides the template; -1 for "
          "1.5 log2 of their number")
      ->type_name("K")
      ->check(at_least_minus_one)
      ->capture_default_str();
  add_memory_option(command, group->memory_gib,
                    "For what matching keeps of shapes for other pairs, in GiB");
  add_tracked_options(command, "Options of every match", group->options.matching);
  add_run_options(command, request);
  set_example(command,
              "isomatch group skulls -o model --report\n"
              "  isomatch group skulls -o model --points 500 --template skull_07",
              "group.md");
  command.callback([group, &request] {
    group->words = request.words;
    group->quiet = request.quiet;
    request.action = [group](const Context& context) { run_group(*group, context); };
  });
}

}  // namespace isomatch::cli
