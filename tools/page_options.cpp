// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "page_options.h"

namespace isomatch::cli {

void add_page_options(CLI::App& command, results::PageOptions& options, const std::string& group) {
  const auto grouped = [&](CLI::Option* option) {
    if (!group.empty()) option->group(group);
    return option;
  };
  CLI::Option* source =
      grouped(command.add_option("--gt-source", options.truth.source,
                                 "Ground truth to show errors of: .vts file of SOURCE"))
          ->type_name("FILE");
  CLI::Option* target = grouped(command.add_option("--gt-target", options.truth.target,
                                                   "The same of TARGET, line by line"))
                            ->type_name("FILE");
  source->needs(target);
  target->needs(source);
  grouped(command.add_option("--up", options.view.up,
                             "What is up in the source's file; guessed by default"))
      ->check(CLI::IsMember({"x", "-x", "y", "-y", "z", "-z"}));
}

}  // namespace isomatch::cli
