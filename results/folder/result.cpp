// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/result.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/io/values_io.h"
#include "results/files/written_files.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

Json read_report(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw BadFile(path, "cannot be opened; is this the folder of a match?");
  try {
    Json report = Json::parse(file);
    if (report.at("options").at("method") == "group")
      throw BadFile(path,
                    "is of a collection, not of a match: open its group.html, or make it with "
                    "isomatch group --report");
    for (const char* side : {"source", "target"}) {
      get_path(report.at(side), "file");
      for (const char* field : {"vertices", "faces"}) report.at(side).at(field).get<int>();
    }
    report.at("options").at("method").get<std::string>();
    if (report.contains("working_folder")) get_path(report, "working_folder");
    return report;
  } catch (const Json::exception& error) {
    throw BadFile(path, fmt::format("is not the report of a match: {}", error.what()));
  }
}

/// The mesh file as it was given, seen from here or from where the match was run.
std::string find_mesh(const Json& report, const char* side, const std::string& place) {
  if (!place.empty()) return place;
  const std::string given = get_path(report[side], "file");
  if (fs::exists(given)) return given;
  const std::string origin =
      report.contains("working_folder") ? get_path(report, "working_folder") : "";
  const std::string there = (fs::path(origin) / given).lexically_normal().string();
  if (!origin.empty() && fs::exists(there)) return there;
  throw BadFile(given, fmt::format("is not there any more; say where it is with --{}", side));
}

Mesh read_matched_mesh(const Json& report, const char* side, const std::string& path) {
  Mesh mesh = read_mesh(path);
  const int vertices = report[side]["vertices"], faces = report[side]["faces"];
  if (mesh.num_vertices() != vertices || mesh.num_faces() != faces)
    throw BadFile(path, fmt::format("has {} vertices and {} faces, but the {} that was matched had "
                                    "{} and {}",
                                    mesh.num_vertices(), mesh.num_faces(), side, vertices, faces));
  return mesh;
}

/// Empty if there is no such file.
std::vector<float> load_confidence(const std::string& path, const Mesh& mesh) {
  if (!fs::exists(path)) return {};
  const Eigen::VectorXf values = read_values(path, mesh.num_vertices()).col(0).cast<float>();
  return {values.data(), values.data() + values.size()};
}

ResultMap load_map(const MatchResult& result, const std::string& folder) {
  const auto file = [&](const char* name) {
    return result.path((fs::path(folder) / name).string());
  };
  const int source_vertices = result.source.num_vertices();
  ResultMap map{folder, {}, {}, {}};
  const MapChecks checks{source_vertices, result.target.num_vertices(), result.target.num_faces()};
  map.source_to_target =
      read_map(file("source_to_target.txt"), checks, Numbering::kFromZero).source_to_target;
  const std::string bary = file("source_to_target.bary.txt");
  map.points = fs::exists(bary) ? read_map(bary, checks).points
                                : corner_points(result.target, map.source_to_target);
  map.source_confidence = load_confidence(file("source_confidence.txt"), result.source);
  map.target_confidence = load_confidence(file("target_confidence.txt"), result.target);
  const std::string registered = file("registered.ply");
  if (!fs::exists(registered)) return map;
  map.registered = read_mesh(registered).vertices;
  if (map.registered.size() != result.source.vertices.size())
    throw BadFile(registered, "does not have as many vertices as the source");
  return map;
}

}  // namespace

std::string MatchResult::path(const std::string& name) const {
  return (fs::path(folder) / name).string();
}

InputFiles result_inputs(const std::string& folder, const MeshPlaces& places) {
  const Json report = read_report((fs::path(folder) / kReport).string());
  InputFiles inputs({(fs::path(folder) / kReport).string()});
  for (const std::string& name : written_files(folder, Listing::kOfMatch))
    if (name != kPage) inputs.add((fs::path(folder) / name).string());
  inputs.add(find_mesh(report, "source", places.source));
  inputs.add(find_mesh(report, "target", places.target));
  return inputs;
}

MatchResult load_result(const std::string& folder, const MeshPlaces& places) {
  MatchResult result;
  result.folder = folder;
  result.report = read_report(result.path("report.json"));
  result.source_path = find_mesh(result.report, "source", places.source);
  result.target_path = find_mesh(result.report, "target", places.target);
  result.source = read_matched_mesh(result.report, "source", result.source_path);
  result.target = read_matched_mesh(result.report, "target", result.target_path);
  result.maps.push_back(load_map(result, ""));
  for (const Json& alternative : result.report.value("alternatives", Json::array()))
    result.maps.push_back(load_map(result, alternative.value("folder", "")));
  return result;
}

Correspondence load_relation(const MatchResult& result) {
  return read_matches(result.path("correspondence.txt"),
                      {.source_vertices = result.source.num_vertices(),
                       .target_vertices = result.target.num_vertices()},
                      Numbering::kFromZero)
      .matches;
}

const ResultMap& chosen_map(const MatchResult& result, std::size_t alternative) {
  if (alternative >= result.maps.size())
    throw BadFile(result.folder, fmt::format("has no alternative {}", alternative));
  return result.maps[alternative];
}

std::vector<Point> images(const Mesh& target, const ResultMap& map) {
  std::vector<Point> result(map.points.size(), Point::Zero());
  for (std::size_t v = 0; v < result.size(); ++v) {
    if (map.is_matched(static_cast<int>(v))) result[v] = position(target, map.points[v]);
  }
  return result;
}

}  // namespace isomatch::results
