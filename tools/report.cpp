// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <filesystem>
#include <memory>

#include "command.h"
#include "page_options.h"
#include "place_options.h"
#include "program/say.h"
#include "results/files/parent_folders.h"
#include "results/files/written_files.h"
#include "results/page/page.h"

namespace isomatch::cli {
namespace {

struct ReportArguments {
  std::string folder, output;
  results::MeshPlaces places;
  results::PageOptions page;
  bool quiet = false;
};

void run_report(const ReportArguments& arguments, const Context& context) {
  const std::string output =
      arguments.output.empty() ? (std::filesystem::path(arguments.folder) / results::kPage).string()
                               : arguments.output;
  const results::ParentFolders parents(output);
  results::check_page_output(output, arguments.folder, arguments.places, arguments.page.truth);
  context.report(0, "reading");
  results::write_page(output, results::load_shown(arguments.folder, arguments.places),
                      arguments.page, context);
  if (!arguments.quiet) say("written to {}", output);
}

}  // namespace

void add_report(CLI::App& app, Request& request) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App& command = *app.add_subcommand("report", "Make a page that shows a result in 3D");
  command.add_option("DIR", arguments->folder, "Folder that `isomatch match` wrote")->required();
  command
      .add_option("-o,--output", arguments->output,
                  "Page, a .html file, complete in itself; DIR/report.html by default")
      ->type_name("FILE");
  add_places(command, arguments->places);
  add_page_options(command, arguments->page);
  add_run_options(command, request);
  set_example(command,
              "isomatch report cats\n"
              "  isomatch report cats --gt-source cat0.vts --gt-target cat1.vts",
              "report.md");
  command.callback([arguments, &request] {
    arguments->quiet = request.quiet;
    request.action = [arguments](const Context& context) { run_report(*arguments, context); };
  });
}

}  // namespace isomatch::cli
