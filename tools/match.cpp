// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "command.h"
#include "isomatch/error.h"
#include "isomatch/mesh_io.h"
#include "load.h"
#include "match_output.h"
#include "paper_options.h"

namespace isomatch::cli {
namespace {

struct MatchArguments {
  std::string source, target, folder;
  std::string method = "paper";
  std::string geodesics = "w20";
  unsigned long seed = 0;
  PaperOptions options;
};

GeodesicOptions geodesic_options(const std::string& name) {
  if (name == "edges") return GeodesicOptions::edges();
  return name == "w10" ? GeodesicOptions::w10() : GeodesicOptions::w20();
}

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

template <class Work>
auto timed(std::vector<StageTime>& times, std::string_view stage, const Work& work) {
  const StageTimer timer(times, stage);
  return work();
}

MatchInput load(const std::string& path, const GeodesicOptions& geodesics, const Context& context,
                std::vector<StageTime>& times) {
  MeshReadReport read_report;
  Mesh mesh = timed(times, "reading", [&] { return read_mesh(path, &read_report); });
  context.check_stop();
  MeshDiagnosis diagnosis = timed(times, "diagnosis", [&] { return diagnose(mesh); });
  Shape shape = timed(times, "geodesic graph",
                      [&] { return prepare_loaded(path, mesh, geodesics, context); });
  return {path, std::move(mesh), read_report, diagnosis, std::move(shape)};
}

/// `context` with its progress between `first` and `last`.
Context part_of(const Context& context, double first, double last) {
  Context part = context;
  part.progress = [&context, first, last](double fraction, std::string_view stage) {
    if (context.progress) context.progress(first + fraction * (last - first), stage);
  };
  return part;
}

void print_summary(const MatchRun& run, const std::string& folder) {
  const PaperLevel& last = run.result.levels.back();
  const DistortionSummary distortion = summarize(last.distortion);
  fmt::print("{} matches at level {}, D_iso {:.4f}, maximum {:.4f} (over the largest geodesic)\n",
             last.matches.size(), run.result.levels.size() - 1, distortion.mean, distortion.max);
  for (const auto& [name, input] : {std::pair{"source", &run.source}, {"target", &run.target}}) {
    for (const std::string& warning : input->diagnosis.warnings())
      fmt::print("! {}: {}\n", name, warning);
  }
  fmt::print("written to {}\n", folder);
}

Json options_json(const MatchArguments& arguments) {
  Json json{
      {"method", arguments.method}, {"geodesics", arguments.geodesics}, {"seed", arguments.seed}};
  for_each_paper_option(arguments.options, [&](const char* name, const auto& value, const char*) {
    json[name] = value;
  });
  return json;
}

void run_match(const MatchArguments& arguments, const Context& context, bool quiet) {
  arguments.options.validate();
  check_folder(arguments.folder);
  const GeodesicOptions geodesics = geodesic_options(arguments.geodesics);
  std::vector<StageTime> times;
  context.report(0, "reading");
  MatchInput source = load(arguments.source, geodesics, context, times);
  context.report(0.05, "reading");
  MatchInput target = load(arguments.target, geodesics, context, times);
  PaperResult result =
      match_paper(source.shape, target.shape, arguments.options, part_of(context, 0.1, 0.95));
  times.insert(times.end(), result.times.begin(), result.times.end());
  const MatchRun run{std::move(source), std::move(target), options_json(arguments),
                     std::move(result), std::move(times)};
  context.report(0.95, "writing");
  write_match(arguments.folder, run);
  if (!quiet) print_summary(run, arguments.folder);
}

}  // namespace

void add_match(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<MatchArguments>();
  CLI::App& command =
      *app.add_subcommand("match", "Find the correspondence between two meshes of the same thing");
  command.add_option("SOURCE", arguments->source, "OFF, OBJ, PLY or STL file")->required();
  command.add_option("TARGET", arguments->target, "OFF, OBJ, PLY or STL file")->required();
  command.add_option("-o,--output", arguments->folder, "Folder for the results")->required();
  command.add_option("--method", arguments->method, "paper: Sahillioglu and Yemez 2011")
      ->check(CLI::IsMember({"paper"}))
      ->capture_default_str();
  command
      .add_option("--geodesics", arguments->geodesics,
                  "w20 and w10: straight lines across triangles; edges: as in the paper")
      ->check(CLI::IsMember({"w20", "w10", "edges"}))
      ->capture_default_str();
  command
      .add_option("--seed", arguments->seed,
                  "Seed of random choices, of which the paper's method makes none")
      ->capture_default_str();
  for_each_paper_option(arguments->options, [&](const char* name, auto& value, const char* help) {
    command.add_option(fmt::format("--{}", name), value, help)->capture_default_str();
  });
  add_run_options(command, request);
  set_example(command, "isomatch match cat0.off cat1.off -o cats");
  command.callback([arguments, &request] {
    request.action = [arguments, &request](const Context& context) {
      run_match(*arguments, context, request.quiet);
    };
  });
}

}  // namespace isomatch::cli
