// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "command.h"
#include "match/method.h"
#include "page_options.h"
#include "program/say.h"
#include "results/files/outputs.h"
#include "results/files/parent_folders.h"
#include "results/files/written_files.h"
#include "results/page/page.h"

namespace isomatch::cli {
namespace {

struct MatchCommand {
  MatchArguments arguments;
  std::string method = "tracked";
  std::map<std::string, Method> methods;
  /// Whether to make a page of the result, and how.
  bool report = false;
  results::PageOptions page;
};

constexpr const char* kReportGroup = "Options of --report";

std::string group_name(const std::string& method) {
  return fmt::format("Options of --method {}", method);
}

/// CLI11's `needs` would name the options it found instead.
void refuse_options_without_report(const CLI::App& command, const MatchCommand& match) {
  for (const CLI::Option* option : command.get_options()) {
    if (!match.report && option->get_group() == kReportGroup && option->count() > 0)
      throw CLI::ValidationError(option->get_name(), "is of use with --report only");
  }
}

void refuse_options_of_others(const CLI::App& command, const MatchCommand& match) {
  for (const auto& [name, method] : match.methods) {
    if (name == match.method) continue;
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_group() == group_name(name) && option->count() > 0)
        throw CLI::ValidationError(
            option->get_name(),
            fmt::format("belongs to --method {}, not to --method {}", name, match.method));
    }
  }
}

void add_common_options(CLI::App& command, MatchCommand& match) {
  MatchArguments& arguments = match.arguments;
  command.add_option("SOURCE", arguments.source, "OFF, OBJ, PLY, STL, GLB, glTF or MAT file")
      ->required();
  command.add_option("TARGET", arguments.target, "OFF, OBJ, PLY, STL, GLB, glTF or MAT file")
      ->required();
  command
      .add_option("-o,--output", arguments.folder,
                  "Folder for the results; missing ones are made, also above it")
      ->type_name("DIR")
      ->required();
  command
      .add_option("--method", match.method,
                  "tracked: no flips, points on triangles; paper: Sahillioglu and Yemez 2011")
      ->check(CLI::IsMember({"tracked", "paper"}))
      ->capture_default_str();
}

void run_match(const MatchCommand& match, const Context& context) {
  const MatchArguments& arguments = match.arguments;
  if (match.report) results::check_page_available();
  results::check_folder_name(arguments.folder);
  const results::ParentFolders parents(arguments.folder);
  std::optional<results::ShownMatch> shown = match.methods.at(match.method)(arguments, context);
  if (!shown) return;
  const std::string page = (std::filesystem::path(arguments.folder) / results::kPage).string();
  results::write_page(page, std::move(*shown), match.page, context);
  if (!arguments.quiet) say("to look at it, open {}", page);
}

}  // namespace

void add_match(CLI::App& app, Request& request) {
  const auto match = std::make_shared<MatchCommand>();
  CLI::App& command =
      *app.add_subcommand("match", "Find the correspondence between two meshes of the same thing");
  add_common_options(command, *match);
  add_run_options(command, request);
  match->methods["tracked"] = add_tracked_method(command, group_name("tracked"));
  match->methods["paper"] = add_paper_method(command, group_name("paper"));
  command.add_flag("--report", match->report, "Make a page that shows the result: DIR/report.html");
  add_page_options(command, match->page, kReportGroup);
  set_example(command,
              "isomatch match cat0.off cat1.off -o cats\n"
              "  isomatch match cat0.off cat1.off -o cats --method paper --levels 6",
              "files.md");
  command.callback([match, &command, &request] {
    refuse_options_of_others(command, *match);
    refuse_options_without_report(command, *match);
    match->arguments.words = request.words;
    match->arguments.quiet = request.quiet;
    match->arguments.page = match->report;
    match->arguments.truth = match->page.truth;
    request.action = [match](const Context& context) { run_match(*match, context); };
  });
}

}  // namespace isomatch::cli
