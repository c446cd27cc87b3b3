// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/metrics.h"

#include <limits>
#include <optional>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/io/map_file.h"
#include "options.h"
#include "results/evaluation.h"
#include "run.h"
#include "shapes.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

/// A pair of arrays is a map to points, a single one a list of pairs of vertices.
results::MeasuredMap to_map(const MatchInput& source, const MatchInput& target,
                            const py::tuple& map) {
  if (map.size() == 1) return {to_matches(map[0].cast<py::array>(), "matches"), {}};
  SurfaceMap points = to_surface_map(map[0].cast<py::array>(), map[1].cast<py::array>());
  check_map(points, source.shape.num_vertices(), target.mesh().num_faces());
  return results::measured_map(target.shape, {{}, std::move(points)});
}

/// A pair of arrays is a map to points, a single one a map to vertices, none no truth.
std::optional<TrueMap> to_true_map(const MatchInput& source, const MatchInput& target,
                                   const py::tuple& map) {
  if (map.empty()) return std::nullopt;
  if (map.size() == 1) {
    VertexMap vertices = to_integers(map[0].cast<py::array>(), "gt_map");
    check_map(vertices, source.shape.num_vertices(), target.shape.num_vertices());
    return vertices;
  }
  SurfaceMap points = to_surface_map(map[0].cast<py::array>(), map[1].cast<py::array>());
  check_map(points, source.shape.num_vertices(), target.mesh().num_faces());
  return points;
}

/// The error of each source vertex against a truth.
template <class Truth>
py::object errors_of(const MatchInput& source, const MatchInput& target,
                     const results::MeasuredMap& map, const Truth& truth, const RunOptions& how) {
  return adopt(run(how, [&](const Context& context) {
    const auto measure = [&](const auto& measured) {
      return vertex_errors(source.shape, target.shape, truth, measured, context);
    };
    return map.points ? measure(*map.points) : measure(map.matches);
  }));
}

/// All figures as JSON and, `per_vertex`, the errors of source vertices against each truth, None
/// without it.
py::tuple evaluate(const MatchInput& source, const MatchInput& target, const py::tuple& map,
                   const py::tuple& truth, const py::tuple& true_map, bool per_vertex,
                   const py::dict& truth_keywords, const py::dict& distortion_keywords,
                   const RunOptions& how) {
  const results::EvaluationOptions options{to_options<TruthOptions>(truth_keywords),
                                           to_options<DistortionOptions>(distortion_keywords)};
  const results::Truth given{{to_integers(truth[0].cast<py::array>(), "source truth"),
                              to_integers(truth[1].cast<py::array>(), "target truth"),
                              to_integers(truth[2].cast<py::array>(), "symmetric truth")},
                             to_true_map(source, target, true_map)};
  const results::MeasuredMap measured = to_map(source, target, map);
  const results::Evaluation evaluation = run(how, [&](const Context& context) {
    return results::evaluate(source.shape, target.shape, measured, given, options, context);
  });
  const std::string json = results::to_json(evaluation).dump();
  if (!per_vertex) return py::make_tuple(json, py::none(), py::none(), py::none());
  const auto errors = [&](const std::vector<int>& at_target) -> py::object {
    if (at_target.empty()) return py::none();
    const GroundTruth points{given.vertices.source, at_target};
    return errors_of(source, target, measured, points, how);
  };
  return py::make_tuple(
      json, errors(given.vertices.target), errors(given.vertices.symmetric_target),
      given.map ? errors_of(source, target, measured, *given.map, how) : py::object(py::none()));
}

py::tuple distortion(const MatchInput& source, const MatchInput& target, const py::array& matches,
                     const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<DistortionOptions>(keywords);
  const std::vector<Match> pairs = to_matches(matches, "matches");
  const IsometricDistortion result = run(how, [&](const Context& context) {
    return isometric_distortion(source.shape, target.shape, pairs, options, context);
  });
  return py::make_tuple(result.mean, result.maximum, adopt(std::vector(result.per_match)));
}

py::tuple orientation(const MatchInput& source, const MatchInput& target, const py::array& matches,
                      const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<OrientationOptions>(keywords);
  const std::vector<Match> pairs = to_matches(matches, "matches");
  const MapOrientation result = run(how, [&](const Context& context) {
    return map_orientation(source.shape, target.shape, pairs, options, context);
  });
  return py::make_tuple(std::string(to_string(result.verdict)), result.preserved_share,
                        result.mean_sign, result.votes);
}

}  // namespace

void bind_metrics(py::module_& module) {
  register_options<TruthOptions>(module, "truth");
  register_options<DistortionOptions>(module, "distortion");
  register_options<OrientationOptions>(module, "orientation");
  module.def("evaluate", evaluate);
  module.def("read_vts", [](const std::string& path) {
    if (is_vts_file_name(path)) return adopt(read_ground_truth(path, std::nullopt));
    return adopt(read_vertex_list(path, std::numeric_limits<int>::max() - 1, Numbering::kFromOne));
  });
  module.def("read_ground_truth", [](const std::string& path, int num_vertices) {
    return adopt(read_ground_truth(path, num_vertices));
  });
  module.def(
      "read_true_map",
      [](const std::string& path, const MatchInput& source, const MatchInput& target) -> py::tuple {
        TrueMap map = results::read_true_map(path, source.shape, target.shape);
        if (auto* vertices = std::get_if<VertexMap>(&map))
          return py::make_tuple(adopt(std::move(*vertices)));
        auto [triangles, barycentric] = to_arrays(std::get<SurfaceMap>(std::move(map)));
        return py::make_tuple(triangles, barycentric);
      });
  module.def("isometric_distortion", distortion);
  module.def("map_orientation", orientation);
}

}  // namespace isomatch::python
