// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <string_view>

#include "isomatch/io/atomic_file.h"
#include "results/batch/batch.h"

namespace isomatch::results {
namespace {

/// As CSV has it (RFC 4180).
std::string field(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string number(const Json& value) { return value.is_number() ? value.dump() : ""; }

std::string joined(const Json& sentences) {
  std::string all;
  if (sentences.is_array())
    for (const Json& sentence : sentences)
      all += (all.empty() ? "" : "; ") + sentence.get<std::string>();
  return all;
}

double seconds(const Json& report) {
  double sum = 0;
  for (const auto& stage : report.at("seconds")) sum += stage.get<double>();
  return sum;
}

std::string line(const PairOutcome& outcome) {
  const ListedPair& pair = outcome.pair;
  const std::string names =
      fmt::format("{},{},{}", field(pair.name), field(pair.source), field(pair.target));
  if (!outcome.matched())
    return fmt::format("{},failed,,,,,,,,,,{}\n", names, field(outcome.error));
  const Json& report = outcome.report;
  const Json& fit = report.at("fit");
  return fmt::format(
      "{},matched,{},{},{},{},{},{},{},{},{:.3f},\n", names, fit.at("grade").get<std::string>(),
      number(report.at("source_vertices_matched")), number(report.at("source_vertices_unmatched")),
      number(fit.at("stretch")), number(fit.at("unreached")), number(report.at("ambiguity")),
      report.at("map").at("mirrored").get<bool>() ? 1 : 0,
      field(joined(fit.value("reasons", Json::array()))), seconds(report));
}

}  // namespace

void write_pair_table(const std::string& path, const std::vector<PairOutcome>& outcomes) {
  AtomicFile file(path);
  file.write(
      "name,source,target,outcome,fit,source_vertices_matched,source_vertices_unmatched,stretch,"
      "unreached,ambiguity,mirrored,reasons,seconds,error\n");
  for (const PairOutcome& outcome : outcomes) file.write(line(outcome));
  file.commit();
}

}  // namespace isomatch::results
