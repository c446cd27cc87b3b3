// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/mesh/topology.h"
#include "results/files/written_files.h"
#include "results/folder/levels.h"
#include "results/folder/result.h"
#include "state.h"

namespace fs = std::filesystem;
namespace py = pybind11;

namespace isomatch::python {
namespace {

using results::Json;
using results::MatchResult;

bool has_own_file(const std::string& folder, const std::string& name) {
  const std::vector<std::string> files = results::written_files(folder, results::Listing::kOfMatch);
  return std::ranges::count(files, name) > 0 && fs::exists(fs::path(folder) / name);
}

/// What `read` makes of the report; a field that is missing or of another type is a `BadFile`.
template <class Read>
auto from_report(const MatchResult& folder, const Read& read) {
  try {
    return read(folder.report);
  } catch (const Json::exception& error) {
    throw BadFile(folder.path(results::kReport),
                  fmt::format("is not the report of a match: {}", error.what()));
  }
}

/// All stages but the writing of the folder.
std::vector<StageTime> times_of(const Json& report) {
  std::vector<StageTime> times;
  const Json peaks = report.value("peak_memory_mib_after", Json::object());
  for (const auto& [stage, seconds] : report.at("seconds").items())
    if (stage != "writing")
      times.push_back({stage, seconds.get<double>(), peaks.value(stage, 0.0)});
  return times;
}

/// The inverse as far as a relation of vertices tells it.
SurfaceMap inverse_of(const MatchResult& folder, const MatchInput& source,
                      const MatchInput& target) {
  const Correspondence relation = read_matches(folder.path("correspondence.txt"),
                                               {.source_vertices = source.shape.num_vertices(),
                                                .target_vertices = target.shape.num_vertices()},
                                               Numbering::kFromZero)
                                      .matches;
  VertexMap target_to_source(target.shape.num_vertices(), kUnmatched);
  for (const Match& match : relation) target_to_source[match.target] = match.source;
  return corner_points(source.mesh(), target_to_source);
}

std::string inverse_file(const MatchResult& folder, const results::ResultMap& map) {
  return folder.path((fs::path(map.folder) / "target_to_source.bary.txt").string());
}

SurfaceMap read_inverse(const std::string& file, const MatchInput& source,
                        const MatchInput& target) {
  return read_map(file, {.source_vertices = target.shape.num_vertices(),
                         .target_faces = source.mesh().num_faces()})
      .points;
}

std::vector<Point> registered_of(const MatchResult& folder, const results::ResultMap& map) {
  if (map.registered.empty())
    throw BadFile(folder.path((fs::path(map.folder) / "registered.ply").string()), "is missing");
  return map.registered;
}

/// Of the vertices of a shape; 0 where no file tells.
std::vector<float> confidence_of(const std::vector<float>& told, const MatchInput& input) {
  return told.empty() ? std::vector<float>(input.shape.num_vertices(), 0.0F) : told;
}

TrackedMap to_map(const MatchResult& folder, const results::MatchInputs& inputs, std::size_t number,
                  bool has_inverse) {
  const MatchInput &source = inputs.source, &target = inputs.target;
  const results::ResultMap& from = folder.maps[number];
  TrackedMap map;
  map.source_to_target = from.points;
  map.registered = registered_of(folder, from);
  if (has_inverse)
    map.target_to_source = read_inverse(inverse_file(folder, from), source, target);
  else if (number == 0)
    map.target_to_source = inverse_of(folder, source, target);
  else
    map.target_to_source.resize(target.shape.num_vertices());
  map.source_confidence = confidence_of(from.source_confidence, source);
  map.target_confidence = confidence_of(from.target_confidence, target);
  from_report(folder, [&](const Json& report) {
    const Json& figures = number == 0 ? report.at("map") : report.at("alternatives").at(number - 1);
    map.energy = figures.at("energy");
    map.distance = figures.at("distance");
    map.deviation = figures.at("deviation");
    map.distortion = figures.at("distortion");
    map.orientation = figures.at("orientation");
    map.mirrored = figures.value("mirrored", false);
  });
  return map;
}

TrackedResult figures_of(const Json& report) {
  TrackedResult result;
  for (const Json& hypothesis : report.at("hypotheses"))
    result.hypotheses.push_back({hypothesis.at("distortion"), hypothesis.at("orientation"),
                                 hypothesis.at("coarse_energy")});
  result.ambiguity = report.at("ambiguity");
  result.oriented = report.at("oriented");
  if (const auto view = report.find("taken_for"); view != report.end())
    result.taken_for = {view->at("source") == "part",
                        view->at("target") == "part",
                        view->at("scale"),
                        view->at("source_unit"),
                        view->at("target_unit"),
                        view->value("source_cut", false),
                        view->value("target_cut", false)};
  result.times = times_of(report);
  return result;
}

/// Numbers bases in the order in which they are added.
class Bases {
 public:
  explicit Bases(const Shape& shape) : shape_(shape), number_(shape.num_vertices(), kNoVertex) {}

  /// Adds those of these vertices that are new.
  void add(std::vector<int> vertices) {
    std::ranges::sort(vertices);
    for (const int vertex : vertices) {
      const int base = lowest_copy(vertex);
      if (number_[base] != kNoVertex) continue;
      number_[base] = count();
      bases_.push_back(base);
    }
  }
  int number(int vertex) const { return number_[lowest_copy(vertex)]; }
  int count() const { return static_cast<int>(bases_.size()); }
  const std::vector<int>& vertices() const { return bases_; }

 private:
  int lowest_copy(int vertex) const {
    const std::span<const int> copies = shape_.copies(vertex);
    if (copies.empty())
      throw InvalidInput(
          fmt::format("base vertex {} is not on the surface that is matched", vertex));
    return copies.front();
  }

  const Shape& shape_;
  std::vector<int> number_, bases_;
};

results::MeasuredMatches numbered(const results::MeasuredMatches& matches, const Bases& sources,
                                  const Bases& targets) {
  std::vector<std::pair<Match, double>> pairs;
  for (std::size_t m = 0; m < matches.matches.size(); ++m) {
    const auto& [source, target] = matches.matches[m];
    pairs.push_back({{sources.number(source), targets.number(target)}, matches.distortion[m]});
  }
  std::ranges::sort(pairs);
  // Copies of a vertex on a seam.
  const auto repeated = std::ranges::unique(pairs, {}, &std::pair<Match, double>::first);
  pairs.erase(repeated.begin(), repeated.end());
  results::MeasuredMatches result;
  for (const auto& [match, distortion] : pairs) {
    result.matches.push_back(match);
    result.distortion.push_back(distortion);
  }
  return result;
}

std::vector<int> vertices_of(const Correspondence& matches, int Match::*side) {
  std::vector<int> vertices;
  for (const Match& match : matches) vertices.push_back(match.*side);
  return vertices;
}

PaperLevel to_level(const results::ResultLevel& from, const Json& figures, Bases& sources,
                    Bases& targets) {
  sources.add(vertices_of(from.many_to_many.matches, &Match::source));
  targets.add(vertices_of(from.many_to_many.matches, &Match::target));
  results::MeasuredMatches matches = numbered(from.many_to_many, sources, targets);
  results::MeasuredMatches many_to_one = numbered(from.many_to_one, sources, targets);
  if (std::cmp_not_equal(many_to_one.matches.size(), sources.count()) ||
      std::ranges::count(many_to_one.matches, kNoVertex, &Match::target) > 0)
    throw InvalidInput("a level's many-to-one matches are not those of its bases");
  PaperLevel level;
  level.source_radius = figures.at("source_radius");
  level.target_radius = figures.at("target_radius");
  level.source_bases = sources.count();
  level.target_bases = targets.count();
  level.many_to_one = vertices_of(many_to_one.matches, &Match::target);
  level.many_to_one_distortion = std::move(many_to_one.distortion);
  level.matches = std::move(matches.matches);
  level.distortion = std::move(matches.distortion);
  level.outliers_moved = figures.at("outliers_moved");
  return level;
}

Json level_figures(const MatchResult& folder, std::size_t levels) {
  const std::string path = folder.path("levels.json");
  std::ifstream file(path);
  if (!file) throw BadFile(path, "cannot be opened");
  Json figures = Json::parse(file, nullptr, false);
  if (!figures.is_array() || figures.size() != levels || levels == 0)
    throw BadFile(path, "does not list the levels of the match");
  return figures;
}

std::vector<PaperLevel> levels_of(const MatchResult& folder, Bases& sources, Bases& targets) {
  const std::vector<results::ResultLevel> files = results::load_levels(folder);
  const Json figures = level_figures(folder, files.size());
  std::vector<PaperLevel> levels;
  for (std::size_t k = 0; k < files.size(); ++k) {
    try {
      levels.push_back(to_level(files[k], figures[k], sources, targets));
    } catch (const InvalidInput& error) {
      throw BadFile(folder.path(fmt::format("levels/{:02}", k)), error.what());
    } catch (const Json::exception& error) {
      throw BadFile(folder.path("levels.json"), error.what());
    }
  }
  return levels;
}

/// Where the landmarks are: in the folder, or where they were when the match was run.
std::string landmark_file(const MatchResult& folder) {
  return from_report(folder, [&](const Json& report) -> std::string {
    const Json& options = report.at("options");
    if (!options.contains("landmarks") || options["landmarks"].is_null()) return {};
    if (has_own_file(folder.folder, "landmarks.txt")) return folder.path("landmarks.txt");
    const std::string given = results::get_path(options, "landmarks");
    return fs::exists(given)
               ? given
               : (fs::path(results::get_path(report, "working_folder")) / given).string();
  });
}

std::string method_of(const MatchResult& folder) {
  const std::string method = folder.report["options"]["method"];
  if (method != "tracked" && method != "paper")
    throw BadFile(folder.path(results::kReport), "has a method that is not known: " + method);
  return method;
}

std::string geodesics_of(const MatchResult& folder) {
  return from_report(folder, [](const Json& report) {
    return report.at("options").value("geodesics", std::string("w20"));
  });
}

/// Reads the folder. Meshes that were given as arrays lie in it, wherever it is now; others are
/// looked for where they were, unless `places` tells. Throws `BadFile`.
MatchResult load_folder(const std::string& folder, results::MeshPlaces places) {
  for (auto& [place, name] : {std::pair<std::string&, const char*>(places.source, "source.ply"),
                              std::pair<std::string&, const char*>(places.target, "target.ply")}) {
    if (place.empty() && has_own_file(folder, name)) place = (fs::path(folder) / name).string();
  }
  return results::load_result(folder, places);
}

/// The landmarks of the match, source and target vertices; none if their file is not there any
/// more. Throws `BadFile`.
std::vector<Match> landmarks_of(const MatchResult& folder) {
  const std::string file = landmark_file(folder);
  if (file.empty() || !fs::exists(file)) return {};
  return read_landmarks(file, {folder.source.num_vertices(), folder.target.num_vertices()});
}

/// The match that `folder` tells of, between the meshes that it was made of. Throws `BadFile`.
TrackedMatch tracked_of(const MatchResult& folder, const MatchInput& source,
                        const MatchInput& target) {
  TrackedMatch match{{to_inputs(source, target), folder.report.at("options")}};
  match.result = from_report(folder, figures_of);
  match.has_inverse = fs::exists(inverse_file(folder, folder.maps.front()));
  for (std::size_t k = 0; k < folder.maps.size(); ++k)
    match.result.maps.push_back(to_map(folder, match.inputs, k, match.has_inverse));
  from_report(folder, [&](const Json& report) {
    match.fits.push_back(results::to_fit(report.at("fit")));
    for (const Json& alternative : report.at("alternatives"))
      match.fits.push_back(results::to_fit(alternative.at("fit")));
    for (const auto& [s, t] :
         report.at("contradicted_landmarks").get<std::vector<std::array<int, 2>>>())
      match.result.contradicted_landmarks.push_back({s, t});
  });
  return match;
}

/// The same by the paper's method. A folder does not have the order in which bases of one level
/// were selected: they are in that of their numbers.
results::PaperRun paper_of(const MatchResult& folder, const MatchInput& source,
                           const MatchInput& target) {
  Bases sources(source.shape), targets(target.shape);
  PaperResult result;
  result.levels = levels_of(folder, sources, targets);
  result.source_bases = sources.vertices();
  result.target_bases = targets.vertices();
  result.source_to_target = folder.maps.front().source_to_target;
  std::array<double, 2> max_geodesics{};
  Fit fit;
  from_report(folder, [&](const Json& report) {
    fit = results::to_fit(report.at("fit"));
    result.complete = report.at("complete");
    result.times = times_of(report);
    max_geodesics = {report.at("source").at("max_geodesic"),
                     report.at("target").at("max_geodesic")};
  });
  return {to_inputs(source, target), folder.report.at("options"), std::move(result), max_geodesics,
          std::move(fit)};
}

}  // namespace

void bind_folder(py::module_& module) {
  py::class_<MatchResult>(module, "Folder")
      .def(py::init(
          [](const std::string& folder, const std::string& source, const std::string& target) {
            return load_folder(folder, {source, target});
          }))
      .def_property_readonly("method", method_of)
      .def_property_readonly(
          "source", [](const MatchResult& folder) { return py::bytes(folder.source_path); })
      .def_property_readonly(
          "target", [](const MatchResult& folder) { return py::bytes(folder.target_path); })
      .def_property_readonly("geodesics", geodesics_of)
      .def_property_readonly(
          "landmarks", [](const MatchResult& folder) { return to_array(landmarks_of(folder)); })
      .def("tracked", tracked_of)
      .def("paper", paper_of);
}

}  // namespace isomatch::python
