// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <memory>

#include "command.h"
#include "isomatch/version.h"
#include "program/help_format.h"
#include "program/program.h"

namespace isomatch::cli {
namespace {

void describe_program(CLI::App& app, Request& request) {
  app.set_version_flag("--version", fmt::format("isomatch {}", kVersion),
                       "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.formatter(std::make_shared<HelpFormat>());
  add_match(app, request);
  add_batch(app, request);
  add_group(app, request);
  add_eval(app, request);
  add_info(app, request);
  add_synth(app, request);
  add_render(app, request);
  add_report(app, request);
  add_transfer(app, request);
  add_convert(app, request);
  set_example(app, "isomatch match cat0.off cat1.off -o cats", "index.md");
}

}  // namespace
}  // namespace isomatch::cli

int main(int argc, char** argv) {
  using namespace isomatch::cli;
  restart_without_spinning(argv);
  Request request;
  CLI::App app("Dense correspondence between two triangle meshes of the same thing.", "isomatch");
  describe_program(app, request);
  return run_program(app, request, argc, argv);
}
