// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/tracked.h"

#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "match.h"
#include "options.h"
#include "results/folder/tracked_output.h"
#include "run.h"
#include "shapes.h"
#include "state.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

const char* const kMethod = "tracked";

TrackedMatch match(const MatchInput& source, const MatchInput& target, const py::array& landmarks,
                   const py::dict& keywords, const RunOptions& how) {
  auto options = to_options<TrackedOptions>(keywords);
  TrackedMatch match{{to_inputs(source, target), report_options(kMethod, options)}};
  options.landmarks = to_matches(landmarks, "landmarks");
  match.result = run(how, [&](const Context& context) {
    TrackedResult result =
        match_tracked(source.shape, target.shape, options, results::matching_part(context));
    match.fits = results::fits_of(match.inputs, result, context);
    return result;
  });
  return match;
}

py::dict figures(const TrackedMap& map) {
  py::dict result;
  result["energy"] = map.energy;
  result["distance"] = map.distance;
  result["deviation"] = map.deviation;
  result["distortion"] = map.distortion;
  result["orientation"] = map.orientation;
  result["mirrored"] = map.mirrored;
  return result;
}

py::dict taken_for(const TrackedMatch& run) {
  const PairView& view = run.result.taken_for;
  const auto word = [](bool is_part) { return is_part ? "part" : "whole"; };
  py::dict result;
  result["source"] = word(view.source_is_part);
  result["target"] = word(view.target_is_part);
  result["scale"] = view.scale;
  result["source_cut"] = view.source_is_cut;
  result["target_cut"] = view.target_is_cut;
  return result;
}

py::list hypotheses(const TrackedMatch& run) {
  py::list result;
  for (const HypothesisSummary& hypothesis : run.result.hypotheses)
    result.append(
        py::make_tuple(hypothesis.distortion, hypothesis.orientation, hypothesis.coarse_energy));
  return result;
}

std::vector<std::string> files_of(const TrackedMatch& run, const SavedAs& saved) {
  return results::tracked_files(static_cast<int>(run.result.maps.size()) - 1,
                                saved.target_to_source);
}

void save(TrackedMatch& run, const SavedAs& saved, const RunOptions& how) {
  run.options.erase("landmarks_escaped");
  run.options["landmarks"] = results::Json();
  if (!saved.landmarks.empty()) results::set_path(run.options, "landmarks", saved.landmarks);
  run.options["target-to-source"] = saved.target_to_source;
  run.target_to_source = saved.target_to_source;
  results::Json defaults = report_options(kMethod, TrackedOptions{});
  defaults["landmarks"] = results::Json();
  defaults["target-to-source"] = false;
  rename(run.inputs, saved, command_line(saved, run.options, defaults));
  results::Json report;
  {
    const py::gil_scoped_release release;
    report = results::write_tracked(make_plan(saved, files_of(run, saved)), run);
  }
  if (!saved.page) return;
  save_page(
      saved, [&] { return results::shown_match(run, saved.folder, std::move(report)); }, how);
}

}  // namespace

void bind_tracked(py::module_& module) {
  register_options<TrackedOptions>(module, kMethod);
  py::class_<TrackedMatch>(module, "TrackedMatch")
      .def_property_readonly("num_maps",
                             [](const TrackedMatch& run) { return run.result.maps.size(); })
      .def("points",
           [](const TrackedMatch& run, std::size_t k) {
             return to_dict(run.inputs.target.mesh(), run.result.maps.at(k).source_to_target);
           })
      .def("inverse_points",
           [](const TrackedMatch& run, std::size_t k) {
             return to_dict(run.inputs.source.mesh(), run.result.maps.at(k).target_to_source);
           })
      .def("confidence",
           [](const TrackedMatch& run, std::size_t k) {
             const TrackedMap& map = run.result.maps.at(k);
             return py::make_tuple(adopt(std::vector(map.source_confidence)),
                                   adopt(std::vector(map.target_confidence)));
           })
      .def_property_readonly("taken_for", taken_for)
      .def("registered", [](const TrackedMatch& run,
                            std::size_t k) { return to_array(run.result.maps.at(k).registered); })
      .def("figures",
           [](const TrackedMatch& run, std::size_t k) { return figures(run.result.maps.at(k)); })
      .def("correspondence",
           [](const TrackedMatch& run) { return to_array(results::relation(run)); })
      .def_property_readonly("hypotheses", hypotheses)
      .def_property_readonly("doubts", [](const TrackedMatch& run) { return results::doubts(run); })
      .def("fit", [](const TrackedMatch& run, std::size_t k) { return to_dict(run.fits.at(k)); })
      .def_property_readonly(
          "contradicted_landmarks",
          [](const TrackedMatch& run) { return to_array(run.result.contradicted_landmarks); })
      .def_property_readonly("has_inverse", [](const TrackedMatch& run) { return run.has_inverse; })
      .def_property_readonly("ambiguity",
                             [](const TrackedMatch& run) { return run.result.ambiguity; })
      .def_property_readonly("oriented",
                             [](const TrackedMatch& run) { return run.result.oriented; })
      .def_property_readonly("seconds",
                             [](const TrackedMatch& run) { return to_dict(run.result.times); })
      .def("check_save", [](const TrackedMatch& run,
                            const SavedAs& saved) { check_save(saved, files_of(run, saved)); })
      .def("save", save)
      .def_property_readonly("state", [](const TrackedMatch& run) { return to_state(run); });
  module.def("tracked_of_state", to_tracked);
  module.def("match_tracked", match);
}

}  // namespace isomatch::python
