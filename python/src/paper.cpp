// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/paper.h"

#include "arrays.h"
#include "bindings.h"
#include "match.h"
#include "options.h"
#include "results/folder/base_matches.h"
#include "results/folder/paper_output.h"
#include "run.h"
#include "shapes.h"
#include "state.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

using results::PaperRun;

const char* const kMethod = "paper";

PaperRun match(const MatchInput& source, const MatchInput& target, const std::string& geodesics,
               const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<PaperOptions>(keywords);
  results::MatchInputs inputs = to_inputs(source, target);
  Fit fit;
  PaperResult result = run(how, [&](const Context& context) {
    PaperResult found =
        match_paper(source.shape, target.shape, options, results::matching_part(context));
    fit = results::fit_of(inputs, found, context);
    return found;
  });
  results::Json json = report_options(kMethod, options);
  json["geodesics"] = geodesics;
  // Distances are known by now.
  const std::array max_geodesics{source.shape.max_geodesic(), target.shape.max_geodesic()};
  return {std::move(inputs), std::move(json), std::move(result), max_geodesics, std::move(fit)};
}

/// Matches and the distortion of each.
py::tuple to_tuple(results::MeasuredMatches measured) {
  return py::make_tuple(to_array(std::move(measured.matches)),
                        adopt(std::move(measured.distortion)));
}

py::array_t<int> first_bases(const std::vector<int>& bases, int count) {
  return adopt(std::vector<int>(bases.begin(), bases.begin() + count));
}

py::list levels(const PaperRun& run) {
  const PaperResult& result = run.result;
  std::vector<results::ResultLevel> numbered = results::result_levels(run);
  py::list list;
  for (std::size_t k = 0; k < numbered.size(); ++k) {
    const PaperLevel& level = result.levels[k];
    py::dict dict;
    dict["source_radius"] = level.source_radius;
    dict["target_radius"] = level.target_radius;
    dict["source_bases"] = first_bases(result.source_bases, level.source_bases);
    dict["target_bases"] = first_bases(result.target_bases, level.target_bases);
    dict["matches"] = to_tuple(std::move(numbered[k].many_to_many));
    dict["many_to_one"] = to_tuple(std::move(numbered[k].many_to_one));
    dict["outliers_moved"] = level.outliers_moved;
    list.append(dict);
  }
  return list;
}

py::dict points(const PaperRun& run) {
  VertexMap map = run.result.source_to_target;
  auto [triangles, barycentric] = to_arrays(corner_points(run.inputs.target.mesh(), map));
  py::dict result;
  result["vertices"] = adopt(std::move(map));
  result["triangles"] = std::move(triangles);
  result["barycentric"] = std::move(barycentric);
  return result;
}

std::vector<std::string> files_of(const PaperRun& run) {
  return results::paper_files(static_cast<int>(run.result.levels.size()) - 1);
}

void save(PaperRun& run, const SavedAs& saved, const RunOptions& how) {
  // Not the default method.
  results::Json defaults = report_options("tracked", PaperOptions{});
  defaults["geodesics"] = "w20";
  rename(run.inputs, saved, command_line(saved, run.options, defaults));
  results::Json report;
  {
    const py::gil_scoped_release release;
    report = results::write_paper(make_plan(saved, files_of(run)), run);
  }
  if (!saved.page) return;
  save_page(
      saved, [&] { return results::shown_match(run, saved.folder, std::move(report)); }, how);
}

}  // namespace

void bind_paper(py::module_& module) {
  register_options<PaperOptions>(module, kMethod);
  py::class_<PaperRun>(module, "PaperRun")
      .def("points", points)
      .def("correspondence",
           [](const PaperRun& run) {
             const PaperLevel& last = run.result.levels.back();
             return to_array(
                 results::between_vertices(run.inputs, run.result, last.matches, last.distortion)
                     .matches);
           })
      .def_property_readonly("levels", levels)
      .def_property_readonly("complete", [](const PaperRun& run) { return run.result.complete; })
      .def_property_readonly("seconds",
                             [](const PaperRun& run) { return to_dict(run.result.times); })
      .def("check_save",
           [](const PaperRun& run, const SavedAs& saved) { check_save(saved, files_of(run)); })
      .def("save", save)
      .def("fit", [](const PaperRun& run, std::size_t) { return to_dict(run.fit); })
      .def_property_readonly("state", [](const PaperRun& run) { return to_state(run); });
  module.def("paper_of_state", to_paper);
  module.def("match_paper", match);
}

}  // namespace isomatch::python
