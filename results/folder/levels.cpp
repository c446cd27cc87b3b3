// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/levels.h"

#include <fmt/format.h>

#include <fstream>

#include "isomatch/error.h"

namespace isomatch::results {
namespace {

MeasuredMatches read_matches(const std::string& path, const MatchResult& result) {
  std::ifstream file(path);
  if (!file) throw BadFile(path, "cannot be opened");
  MeasuredMatches measured;
  Match match{};
  for (double distortion = 0; file >> match.source >> match.target >> distortion;) {
    if (match.source < 0 || match.source >= result.source.num_vertices() || match.target < 0 ||
        match.target >= result.target.num_vertices())
      throw BadFile(path, fmt::format("line {}", measured.matches.size() + 1),
                    "a vertex is out of range");
    measured.matches.push_back(match);
    measured.distortion.push_back(distortion);
  }
  if (!file.eof())
    throw BadFile(path, fmt::format("line {}", measured.matches.size() + 1),
                  "expected two vertices and a distortion");
  return measured;
}

}  // namespace

std::vector<ResultLevel> load_levels(const MatchResult& result) {
  if (result.report["options"]["method"] != "paper") return {};
  std::vector<ResultLevel> levels(result.report.value("levels", std::size_t{0}));
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const auto file = [&](const char* name) {
      return result.path(fmt::format("levels/{:02}.{}.txt", k, name));
    };
    levels[k] = {read_matches(file("correspondence"), result),
                 read_matches(file("many_to_one"), result)};
  }
  return levels;
}

}  // namespace isomatch::results
