// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program/request.h"

namespace isomatch::cli {

void add_quiet_option(CLI::App& command, Request& request) {
  command.add_flag("-q,--quiet", request.quiet,
                   "Print warnings and errors only: no progress, no summary");
}

void add_run_options(CLI::App& command, Request& request) {
  command.add_option("--threads", request.threads, "Threads to use")
      ->type_name("N")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  add_quiet_option(command, request);
}

void set_example(CLI::App& command, const std::string& example, const std::string& page) {
  command.footer("Example:\n  " + example + "\n\nDocumentation: docs/" + page +
                 " where the sources are");
}

}  // namespace isomatch::cli
