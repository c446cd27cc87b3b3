// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "options.h"
#include "prepared.h"
#include "results/evaluation.h"
#include "run.h"
#include "vertex_errors.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

cli::MeasuredMap points_map(const PreparedMesh& source, const PreparedMesh& target,
                            const SurfaceMap& map) {
  check_map(source, target, map);
  const Surface& onto = target.surface();
  SurfaceMap points = surface_map(source.surface(), onto, map);
  Correspondence matches = to_correspondence(nearest_vertices(onto.mesh, points));
  return {std::move(matches), std::move(points)};
}

Correspondence pairs_on_surfaces(const PreparedMesh& source, const PreparedMesh& target,
                                 const std::vector<Match>& pairs) {
  check_matches(source, target, pairs);
  Correspondence sorted = pairs;
  std::ranges::sort(sorted);
  return surface_matches(source.surface(), target.surface(), sorted);
}

/// A pair of arrays is a map to points, a single one a list of pairs of vertices.
cli::MeasuredMap to_map(const PreparedMesh& source, const PreparedMesh& target,
                        const py::tuple& map) {
  if (map.size() == 2)
    return points_map(source, target,
                      to_surface_map(map[0].cast<py::array>(), map[1].cast<py::array>()));
  return {pairs_on_surfaces(source, target, to_matches(map[0].cast<py::array>(), "matches")), {}};
}

/// The error of each source vertex against a truth, None without one.
py::object errors_of(const PreparedMesh& source, const PreparedMesh& target,
                     const cli::MeasuredMap& map, const std::vector<int>& at_source,
                     const std::vector<int>& at_target, const RunOptions& how) {
  if (at_target.empty()) return py::none();
  return adopt(run(how, [&](const Context& context) {
    return vertex_errors(source, target, map, at_source, at_target, context);
  }));
}

/// All figures as JSON and, `per_vertex`, the errors of source vertices against both truths.
py::tuple evaluate(const PreparedMesh& source, const PreparedMesh& target, const py::tuple& map,
                   const py::tuple& truth, bool per_vertex, const py::dict& truth_keywords,
                   const py::dict& distortion_keywords, const RunOptions& how) {
  const cli::EvaluationOptions options{to_options<TruthOptions>(truth_keywords),
                                       to_options<DistortionOptions>(distortion_keywords)};
  const cli::TruthVertices vertices{to_integers(truth[0].cast<py::array>(), "source truth"),
                                    to_integers(truth[1].cast<py::array>(), "target truth"),
                                    to_integers(truth[2].cast<py::array>(), "symmetric truth")};
  const cli::MeasuredMap measured = to_map(source, target, map);
  const cli::Evaluation evaluation = run(how, [&](const Context& context) {
    return cli::evaluate(source.shape(context), target.shape(context), measured, vertices, options,
                         context);
  });
  const std::string json = cli::to_json(evaluation).dump();
  if (!per_vertex) return py::make_tuple(json, py::none(), py::none());
  const auto errors = [&](const std::vector<int>& at_target) {
    return errors_of(source, target, measured, vertices.source, at_target, how);
  };
  return py::make_tuple(json, errors(vertices.target), errors(vertices.symmetric_target));
}

/// `values` of `measured` matches between surface vertices, for each of `pairs` of input vertices.
std::vector<double> spread(const PreparedMesh& source, const PreparedMesh& target,
                           const std::vector<Match>& pairs, const Correspondence& measured,
                           const std::vector<double>& values) {
  std::vector<double> result(pairs.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Match match{source.surface().surface_vertex[pairs[i].source],
                      target.surface().surface_vertex[pairs[i].target]};
    const auto place = std::ranges::lower_bound(measured, match);
    if (place != measured.end() && *place == match) result[i] = values[place - measured.begin()];
  }
  return result;
}

py::tuple distortion(const PreparedMesh& source, const PreparedMesh& target,
                     const py::array& matches, const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<DistortionOptions>(keywords);
  const std::vector<Match> pairs = to_matches(matches, "matches");
  const Correspondence measured = pairs_on_surfaces(source, target, pairs);
  const IsometricDistortion result = run(how, [&](const Context& context) {
    return isometric_distortion(source.shape(context), target.shape(context), measured, options,
                                context);
  });
  return py::make_tuple(result.mean, result.maximum,
                        adopt(spread(source, target, pairs, measured, result.per_match)));
}

py::tuple orientation(const PreparedMesh& source, const PreparedMesh& target,
                      const py::array& matches, const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<OrientationOptions>(keywords);
  const Correspondence measured = pairs_on_surfaces(source, target, to_matches(matches, "matches"));
  const MapOrientation result = run(how, [&](const Context& context) {
    return map_orientation(source.shape(context), target.shape(context), measured, options,
                           context);
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
    return adopt(read_vertex_list(path, std::numeric_limits<int>::max() - 1, Numbering::kFromOne));
  });
  module.def("read_ground_truth", [](const std::string& path, int num_vertices) {
    return adopt(read_ground_truth(path, num_vertices));
  });
  module.def("isometric_distortion", distortion);
  module.def("map_orientation", orientation);
}

}  // namespace isomatch::python
