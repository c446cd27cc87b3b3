// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <memory>

#include "bench/child.h"
#include "bench/measure.h"
#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/version.h"
#include "program/help_format.h"
#include "program/program.h"
#include "program/request.h"
#include "program/say.h"

namespace isomatch::baselines {
namespace {

using results::Json;

struct BenchArguments {
  Pair pair;
  std::vector<std::string> methods;
  std::string output;
  MeasureOptions options;
};

void check_arguments(const BenchArguments& arguments) {
  for (const std::string& name : arguments.methods) find_method(name);
  if (!arguments.output.empty()) const AtomicFile place(arguments.output);
  const std::string& folder = arguments.options.map_folder;
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw BadFile(folder, "is not a folder");
}

/// What the child says: a method's measures, or which file it could not use and why.
std::string measured(const Method& method, const BenchArguments& arguments,
                     const Context& context) {
  try {
    return measure(method, arguments.pair, arguments.options, context).dump();
  } catch (const BadFile& error) {
    return Json{{"bad_file", error.what()}}.dump();
  } catch (const std::exception& error) {
    return Json{{"result", {{"failure", error.what()}}}}.dump();
  }
}

void add_method(const Method& method, const BenchArguments& arguments, const Context& context,
                Json& report) {
  Context own = context;
  own.progress = nullptr;
  const ChildOutcome outcome =
      run_child([&] { return measured(method, arguments, own); }, context.stop);
  Json& result = report["methods"][method.name];
  if (outcome.signal != 0) {
    result["failure"] = fmt::format("killed: {}", strsignal(outcome.signal));
    return;
  }
  const Json json = Json::parse(outcome.output);
  if (json.contains("bad_file")) throw InvalidInput(json["bad_file"]);
  for (const char* side : {"source", "target"})
    if (json.contains(side)) report[side] = json[side];
  result = json["result"];
}

void write_report(const std::string& path, const Json& report) {
  const std::string text = report.dump(1);
  if (path.empty()) return cli::say("{}", text);
  AtomicFile file(path);
  file.write(text + "\n");
  file.commit();
}

void run_bench(const BenchArguments& arguments, const Context& context) {
  check_arguments(arguments);
  Json report{{"isomatch", kVersion},
              {"threads", context.threads},
              {"source", nullptr},
              {"target", nullptr},
              {"methods", Json::object()}};
  const double count = static_cast<double>(arguments.methods.size());
  for (std::size_t i = 0; i < arguments.methods.size(); ++i) {
    context.report(static_cast<double>(i) / count, arguments.methods[i]);
    add_method(find_method(arguments.methods[i]), arguments, context, report);
  }
  write_report(arguments.output, report);
}

void add_files(CLI::App& app, BenchArguments& arguments) {
  Pair& pair = arguments.pair;
  app.add_option("SOURCE", pair.source, "Mesh that the maps start from")->required();
  app.add_option("TARGET", pair.target, "Mesh that the maps lead to")->required();
  auto* source = app.add_option("--gt-source", pair.truth.source, "Ground truth on the source")
                     ->type_name("VTS");
  auto* target = app.add_option("--gt-target", pair.truth.target, "Ground truth on the target")
                     ->type_name("VTS")
                     ->needs(source);
  source->needs(target);
  app.add_option("--gt-target-sym", pair.truth.symmetric_target,
                 "Ground truth on the target under the left-right symmetry")
      ->type_name("VTS")
      ->needs(target);
  app.add_option("--gt-map", pair.truth.map,
                 "Ground truth as a map of every source vertex, numbered from zero, -1 where the "
                 "target has no counterpart")
      ->type_name("FILE");
  app.add_option("-o,--output", arguments.output, "Report in JSON; default standard output")
      ->type_name("FILE");
  app.add_option("--write-maps", arguments.options.map_folder,
                 "Write the map of each method into this folder, which must exist")
      ->type_name("DIR");
}

std::string methods_help() {
  std::string help = "Methods, separated by commas:";
  for (const Method& method : methods()) help += fmt::format("\n{}: {}", method.name, method.about);
  return help;
}

void add_options(CLI::App& app, BenchArguments& arguments) {
  for (const Method& method : methods()) arguments.methods.push_back(method.name);
  app.add_option("--methods", arguments.methods, methods_help())
      ->delimiter(',')
      ->type_name("NAMES")
      ->capture_default_str();
  app.add_option("--maps", arguments.options.maps,
                 "Maps to measure, of those that a method makes: final, many_to_many, bases, "
                 "levelK_many_to_one")
      ->delimiter(',')
      ->type_name("NAMES")
      ->capture_default_str();
  app.add_option("--samples", arguments.options.evaluation.truth.max_samples,
                 "Most ground-truth errors to compute, evenly spaced")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--list", arguments.options.evaluation.distortion.list_size,
                 "Matches that distortion is measured against (E)")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

void describe_program(CLI::App& app, BenchArguments& arguments, cli::Request& request) {
  app.set_version_flag("--version", fmt::format("isomatch-bench {}", kVersion));
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.formatter(std::make_shared<cli::HelpFormat>());
  add_files(app, arguments);
  add_options(app, arguments);
  cli::add_run_options(app, request);
  cli::set_example(app,
                   "isomatch-bench --methods tracked,zoomout cat0.off cat1.off --gt-source "
                   "cat0.vts --gt-target cat1.vts --gt-target-sym cat1.sym.vts",
                   "bench.md");
  request.action = [&arguments](const Context& context) { run_bench(arguments, context); };
}

}  // namespace
}  // namespace isomatch::baselines

int main(int argc, char** argv) {
  using namespace isomatch;
  cli::restart_without_spinning(argv);
  cli::Request request;
  baselines::BenchArguments arguments;
  CLI::App app(
      "Runs methods on one pair of meshes, each in a process of its own, and measures them.",
      "isomatch-bench");
  baselines::describe_program(app, arguments, request);
  return cli::run_program(app, request, argc, argv);
}
