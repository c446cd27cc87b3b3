// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/group_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "isomatch/error.h"
#include "isomatch/geodesics/geodesics.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/io/map_file.h"
#include "isomatch/mesh/topology.h"
#include "isomatch/version.h"
#include "results/csv.h"
#include "results/folder/report.h"
#include "results/folder/verdict.h"

namespace isomatch::results {
namespace {

std::string map_name(const std::string& shape, const char* direction) {
  return "maps/" + shape + "." + direction + ".bary.txt";
}

std::string map_between(const std::string& source, const std::string& target) {
  return "maps/" + source + "__" + target + ".bary.txt";
}

/// Calls `visit` with the places in the list of each two shapes.
template <class Visit>
void for_each_pair(std::size_t shapes, const Visit& visit) {
  for (std::size_t source = 0; source < shapes; ++source)
    for (std::size_t target = 0; target < shapes; ++target)
      if (source != target) visit(source, target);
}

constexpr const char* kFromTemplate = "from_template";
constexpr const char* kToTemplate = "to_template";
constexpr const char* kPairTable = "pairs.csv";

/// Empty if there is no number.
std::string field_of(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : std::string();
}

void write_pairs(const std::string& path, const GroupRun& run) {
  const std::vector<std::string>& names = run.collection.names;
  AtomicFile file(path);
  file.write("source,target,cost,cycle_error,use\n");
  for (const GroupPair& pair : run.result.pairs)
    file.write(fmt::format("{},{},{},{},{}\n", csv_field(names[pair.source]),
                           csv_field(names[pair.target]), field_of(pair.cost),
                           field_of(pair.cycle_error), to_string(pair.use)));
  file.commit();
}

Json shapes_json(const GroupRun& run) {
  const std::vector<double> errors = cycle_errors(run);
  Json shapes = Json::array();
  for (std::size_t k = 0; k < run.collection.names.size(); ++k) {
    const GroupMember& member = run.result.members[k];
    const auto missing = std::ranges::count(member.from_template, kNoFace, &SurfacePoint::face);
    Json shape = Json::object();
    set_path(shape, "name", run.collection.names[k]);
    set_path(shape, "path", run.collection.paths[k]);
    shape.update({{"vertices", run.collection.shapes[k].num_vertices()},
                  {"fit", to_json(member.fit)},
                  {"cycle_error", errors[k]},
                  {"points_missing", missing}});
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

Json report_of(const GroupRun& run) {
  Json report{{"isomatch", kVersion}};
  set_paths(report, "command", run.words);
  set_path(report, "working_folder", run.working_folder);
  Json left_out = Json::array();
  for (const LeftOut& one : run.collection.left_out) {
    Json entry = Json::object();
    set_path(entry, "path", one.path);
    entry["reason"] = one.reason;
    left_out.push_back(std::move(entry));
  }
  set_path(report, "template", run.collection.names[run.result.template_shape]);
  report.update({{"options", run.options},
                 {"shapes", shapes_json(run)},
                 {"left_out", left_out},
                 {"pairs", run.result.pairs.size()}});
  report.update(report_tail(run.result.times));
  return report;
}

}  // namespace

std::vector<double> cycle_errors(const GroupRun& run) {
  std::vector<double> sums(run.collection.names.size(), 0);
  std::vector<int> counts(sums.size(), 0);
  for (const GroupPair& pair : run.result.pairs) {
    if (!std::isfinite(pair.cycle_error)) continue;
    for (const int shape : {pair.source, pair.target}) {
      sums[shape] += pair.cycle_error;
      ++counts[shape];
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    if (counts[k] > 0) sums[k] /= counts[k];
  return sums;
}

CorrespondingPoints points_of(const GroupRun& run, const std::vector<int>& template_vertices) {
  CorrespondingPoints result;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < run.collection.shapes.size(); ++k) {
    const GroupMember& member = run.result.members[k];
    std::vector<Point>& points = result.points.emplace_back();
    std::vector<bool>& present = result.present.emplace_back();
    for (const int v : template_vertices) {
      present.push_back(member.from_template[v].face != kNoFace);
      points.push_back(present.back() ? member.registered[v] : Point(nan, nan, nan));
    }
  }
  return result;
}

std::vector<int> spread_vertices(const GroupRun& run, int count, const Context& context) {
  const Shape& shape = run.collection.shapes[run.result.template_shape];
  std::vector<int> vertices;
  for (int v = 0; v < shape.num_vertices(); ++v)
    if (shape.on_surface(v) && (count == 0 || shape.copies(v).front() == v)) vertices.push_back(v);
  if (count == 0 || std::ssize(vertices) <= count) return vertices;
  const GeodesicGraph graph(shape.mesh(), GeodesicOptions::edges(), context);
  std::vector<int> spread;
  for (const int k : farthest_points(graph, vertices, count, 0, context))
    spread.push_back(vertices[k]);
  std::ranges::sort(spread);
  return spread;
}

std::vector<std::string> group_run_files(const std::vector<std::string>& names, bool all_maps) {
  std::vector<std::string> files = group_files(names);
  for (const std::string& name : names)
    for (const char* direction : {kFromTemplate, kToTemplate})
      files.push_back(map_name(name, direction));
  if (all_maps)
    for_each_pair(names.size(), [&](std::size_t source, std::size_t target) {
      files.push_back(map_between(names[source], names[target]));
    });
  std::vector<std::string> sorted = files;
  std::ranges::sort(sorted);
  const auto twice = std::ranges::adjacent_find(sorted);
  if (twice != sorted.end())
    throw InvalidInput(fmt::format("two maps would have the name {}: rename a shape", *twice));
  files.emplace_back(kPairTable);
  return files;
}

Json write_group_run(const ResultPlan& plan, const GroupRun& run, const GroupOutput& output) {
  ResultFolder folder(plan);
  write_group(folder, output);
  for (std::size_t k = 0; k < run.collection.names.size(); ++k) {
    const GroupMember& member = run.result.members[k];
    const std::string& name = run.collection.names[k];
    isomatch::write_map(folder.add(map_name(name, kFromTemplate)), {{}, member.from_template});
    isomatch::write_map(folder.add(map_name(name, kToTemplate)), {{}, member.to_template});
  }
  if (run.all_maps)
    for_each_pair(run.collection.names.size(), [&](std::size_t source, std::size_t target) {
      const std::vector<std::string>& names = run.collection.names;
      isomatch::write_map(folder.add(map_between(names[source], names[target])),
                          {{},
                           member_map(run.collection.shapes, run.result, static_cast<int>(source),
                                      static_cast<int>(target))});
    });
  write_pairs(folder.add(kPairTable), run);
  return folder.write_report(report_of(run));
}

}  // namespace isomatch::results
