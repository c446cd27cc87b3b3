// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
//
// isomatch-ablation PAIRS
//
// PAIRS has a line a pair: source mesh, target mesh, and a file of truth for each. Reads lines
// "NUMBER VALUE" from standard input, see `for_each_number` (an empty line changes nothing),
// matches all pairs with that number of the tracked method changed, and prints a line: the mean
// error of each pair, x100 over sqrt(area), -1 where there is no map, and the CPU seconds of them
// all. Without PAIRS it prints all numbers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/measure/metrics.h"
#include "tracked/match.h"
#include "tracked/option_list.h"

namespace isomatch {
namespace {

struct Pair {
  Mesh source, target;
  GroundTruth truth;
};

std::vector<Pair> read_pairs(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw BadFile(path, "cannot be opened");
  std::vector<Pair> pairs;
  std::string source, target, source_truth, target_truth;
  while (file >> source >> target >> source_truth >> target_truth)
    pairs.push_back({read_mesh(source),
                     read_mesh(target),
                     {read_ground_truth(source_truth, {}), read_ground_truth(target_truth, {})}});
  return pairs;
}

tracked::Options changed(const std::string& line) {
  tracked::Options options;
  std::istringstream words(line);
  std::string name;
  double value = 0;
  if (!(words >> name)) return options;
  if (!(words >> value)) throw InvalidInput("a number needs a value: " + line);
  bool found = false;
  tracked::for_each_number(options, [&](const std::string& known, auto& number) {
    if (known != name) return;
    number = static_cast<std::remove_reference_t<decltype(number)>>(value);
    found = true;
  });
  if (!found) throw InvalidInput("there is no number " + name);
  return options;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Outcome {
  /// -1 if there is no map.
  double error = -1;
  double seconds = 0;
};

/// Shapes are prepared anew, so that the time is always that of all stages.
Outcome matched(const Pair& pair, const tracked::Options& options) {
  const Shape source(pair.source), target(pair.target);
  Outcome outcome;
  const double start = cpu_seconds();
  try {
    const TrackedResult result = tracked::match(source, target, {}, options, {});
    outcome.seconds = cpu_seconds() - start;
    outcome.error =
        100 * point_errors(source, target, pair.truth, result.maps.front().source_to_target).mean;
  } catch (const InvalidInput&) {
    outcome.seconds = cpu_seconds() - start;
  }
  return outcome;
}

void run(const std::string& file) {
  const std::vector<Pair> pairs = read_pairs(file);
  for (std::string line; std::getline(std::cin, line);) {
    const tracked::Options options = changed(line);
    std::vector<double> errors;
    double seconds = 0;
    for (const Pair& pair : pairs) {
      const Outcome outcome = matched(pair, options);
      errors.push_back(outcome.error);
      seconds += outcome.seconds;
    }
    fmt::print("{:.3f} {:.2f}\n", fmt::join(errors, " "), seconds);
    std::fflush(stdout);
  }
}

void list() {
  tracked::Options options;
  tracked::for_each_number(
      options, [](const std::string& name, auto& number) { fmt::print("{} {}\n", name, number); });
}

}  // namespace
}  // namespace isomatch

int main(int count, char** words) {
  try {
    if (count > 1)
      isomatch::run(words[1]);
    else
      isomatch::list();
  } catch (const std::exception& error) {
    fmt::print(stderr, "isomatch-ablation: {}\n", error.what());
    return 2;
  }
  return 0;
}
