// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/inputs.h"

#include <filesystem>

#include "isomatch/error.h"
#include "load.h"

namespace isomatch::cli {
namespace {

GeodesicOptions geodesic_options(const std::string& name) {
  if (name == "edges") return GeodesicOptions::edges();
  return name == "w10" ? GeodesicOptions::w10() : GeodesicOptions::w20();
}

/// Fails now rather than after the work if the results will have no place.
void check_folder(const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path path = fs::absolute(folder).lexically_normal();
  const fs::path parent =
      path.has_filename() ? path.parent_path() : path.parent_path().parent_path();
  if (fs::exists(path)) {
    if (!fs::is_directory(path)) throw BadFile(folder, "is not a folder");
  } else if (!fs::is_directory(parent)) {
    throw BadFile(folder, "cannot be created: there is no folder " + parent.string());
  }
}

template <class Work>
auto timed(std::vector<StageTime>& times, std::string_view stage, const Work& work) {
  const StageTimer timer(times, stage);
  return work();
}

MatchInput load(const std::string& path, const GeodesicOptions& geodesics, const Context& context,
                std::vector<StageTime>& times) {
  MeshReadReport read_report;
  Mesh mesh = timed(times, "reading", [&] { return read_mesh(path, &read_report); });
  context.check_stop();
  MeshDiagnosis diagnosis = timed(times, "diagnosis", [&] { return diagnose(mesh); });
  Shape shape = timed(times, "geodesic graph",
                      [&] { return prepare_loaded(path, mesh, geodesics, context); });
  return {path, std::move(mesh), read_report, diagnosis, std::move(shape)};
}

}  // namespace

MatchInputs load_inputs(const MatchArguments& arguments, const Context& context) {
  check_folder(arguments.folder);
  const GeodesicOptions geodesics = geodesic_options(arguments.geodesics);
  std::vector<StageTime> times;
  context.report(0, "reading");
  MatchInput source = load(arguments.source, geodesics, context, times);
  context.report(kLoaded / 2, "reading");
  MatchInput target = load(arguments.target, geodesics, context, times);
  return {arguments.words, std::filesystem::current_path().string(), std::move(source),
          std::move(target), std::move(times)};
}

std::vector<std::vector<int>> input_vertices(const Surface& surface) {
  std::vector<std::vector<int>> vertices(surface.num_vertices());
  for (std::size_t v = 0; v < surface.surface_vertex.size(); ++v) {
    if (surface.surface_vertex[v] != kNoVertex)
      vertices[surface.surface_vertex[v]].push_back(static_cast<int>(v));
  }
  return vertices;
}

Context matching_part(const Context& context) {
  Context part = context;
  part.progress = [&context](double fraction, std::string_view stage) {
    if (context.progress) context.progress(kLoaded + fraction * (kMatched - kLoaded), stage);
  };
  return part;
}

}  // namespace isomatch::cli
