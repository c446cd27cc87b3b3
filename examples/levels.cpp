// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// The first levels of the paper's method, with progress and a time limit: base vertices and
// distortion of each level.
#include <chrono>
#include <exception>
#include <iostream>
#include <stop_token>
#include <string_view>

#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/methods/paper.h"

namespace {

/// A computation that uses it throws `isomatch::Cancelled` when the time is over.
isomatch::Context context_with_limit(std::stop_source& stop, std::chrono::seconds limit) {
  isomatch::Context context;
  context.stop = stop.get_token();
  const auto end = std::chrono::steady_clock::now() + limit;
  context.progress = [&stop, end](double fraction, std::string_view stage) {
    std::cerr << static_cast<int>(100 * fraction) << " % " << stage << '\n';
    if (std::chrono::steady_clock::now() > end) stop.request_stop();
  };
  return context;
}

void print_levels(const char* source_file, const char* target_file) {
  std::stop_source stop;
  const isomatch::Context context = context_with_limit(stop, std::chrono::minutes(10));
  const isomatch::Shape source(isomatch::read_mesh(source_file));
  const isomatch::Shape target(isomatch::read_mesh(target_file));

  isomatch::PaperOptions options;
  options.max_levels = 3;
  for (const isomatch::PaperLevel& level :
       isomatch::match_paper(source, target, options, context).levels)
    std::cout << level.source_bases << " and " << level.target_bases << " base vertices, D_iso "
              << isomatch::summarize(level.distortion).mean << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: example_levels SOURCE TARGET\n";
    return 2;
  }
  try {
    print_levels(argv[1], argv[2]);
  } catch (const isomatch::Cancelled&) {
    std::cerr << "out of time\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
