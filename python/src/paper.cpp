// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/paper.h"

#include "arrays.h"
#include "bindings.h"
#include "match.h"
#include "options.h"
#include "prepared.h"
#include "results/folder/input_numbers.h"
#include "results/folder/paper_output.h"
#include "results/folder/result.h"
#include "run.h"
#include "state.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

using results::PaperRun;

const char* const kMethod = "paper";

PaperRun match(const PreparedMesh& source, const PreparedMesh& target, const std::string& geodesics,
               unsigned long seed, const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<PaperOptions>(keywords);
  results::MatchInputs inputs = to_inputs(source, target);
  Fit fit;
  PaperResult result = run(how, [&](const Context& context) {
    PaperResult found = match_paper(source.shape(context), target.shape(context), options,
                                    results::matching_part(context));
    fit = results::fit_of(inputs, found, context);
    return found;
  });
  results::Json json = report_options(kMethod, seed, options);
  json["geodesics"] = geodesics;
  // Shapes are prepared by now.
  const Shape& source_shape = source.shape({});
  const Shape& target_shape = target.shape({});
  return {std::move(inputs),
          std::move(json),
          std::move(result),
          {source_shape.unit * source_shape.max_geodesic,
           target_shape.unit * target_shape.max_geodesic},
          std::move(fit)};
}

/// Matches and the distortion of each.
py::tuple to_tuple(results::MeasuredMatches measured) {
  return py::make_tuple(to_array(std::move(measured.matches)),
                        adopt(std::move(measured.distortion)));
}

py::array_t<int> first_bases(const Surface& surface, const std::vector<int>& bases, int count) {
  return adopt(input_numbers(surface, std::span(bases).first(static_cast<std::size_t>(count))));
}

py::dict to_dict(const PaperRun& run, const results::InputNumbers& numbers,
                 const PaperLevel& level) {
  const PaperResult& result = run.result;
  py::dict dict;
  dict["source_radius"] = level.source_radius;
  dict["target_radius"] = level.target_radius;
  dict["source_bases"] =
      first_bases(run.inputs.source.surface, result.source_bases, level.source_bases);
  dict["target_bases"] =
      first_bases(run.inputs.target.surface, result.target_bases, level.target_bases);
  dict["matches"] = to_tuple(numbers.translate(level.matches, level.distortion));
  dict["many_to_one"] = to_tuple(
      numbers.translate(to_correspondence(level.many_to_one), level.many_to_one_distortion));
  dict["outliers_moved"] = level.outliers_moved;
  return dict;
}

py::list levels(const PaperRun& run) {
  const results::InputNumbers numbers(run.inputs, run.result);
  py::list list;
  for (const PaperLevel& level : run.result.levels) list.append(to_dict(run, numbers, level));
  return list;
}

py::dict points(const PaperRun& run) {
  VertexMap map = results::InputNumbers(run.inputs, run.result).source_to_target();
  auto [triangles, barycentric] = to_arrays(corner_points(run.inputs.target.mesh, map));
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
  results::Json defaults = report_options("tracked", 0, PaperOptions{});
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
             return to_array(results::InputNumbers(run.inputs, run.result)
                                 .translate(last.matches, last.distortion)
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
