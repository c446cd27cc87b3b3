// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <map>
#include <memory>

#include "command.h"
#include "match/method.h"

namespace isomatch::cli {
namespace {

struct MatchCommand {
  MatchArguments arguments;
  std::string method = "tracked";
  std::map<std::string, Method> methods;
};

std::string group_name(const std::string& method) {
  return fmt::format("Options of --method {}", method);
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
  command.add_option("SOURCE", arguments.source, "OFF, OBJ, PLY or STL file")->required();
  command.add_option("TARGET", arguments.target, "OFF, OBJ, PLY or STL file")->required();
  command.add_option("-o,--output", arguments.folder, "Folder for the results")->required();
  command
      .add_option("--method", match.method,
                  "tracked: no flips, points on triangles; paper: Sahillioglu and Yemez 2011")
      ->check(CLI::IsMember({"tracked", "paper"}))
      ->capture_default_str();
  command
      .add_option("--geodesics", arguments.geodesics,
                  "w20 and w10: straight lines across triangles; edges: as in the paper")
      ->check(CLI::IsMember({"w20", "w10", "edges"}))
      ->capture_default_str();
  command
      .add_option("--seed", arguments.seed,
                  "Seed of random choices, of which neither method makes any")
      ->capture_default_str();
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
  set_example(command,
              "isomatch match cat0.off cat1.off -o cats\n"
              "  isomatch match cat0.off cat1.off -o cats --method paper --levels 6");
  command.callback([match, &command, &request] {
    refuse_options_of_others(command, *match);
    match->arguments.words = request.words;
    match->arguments.quiet = request.quiet;
    request.action = [match](const Context& context) {
      match->methods.at(match->method)(match->arguments, context);
    };
  });
}

}  // namespace isomatch::cli
