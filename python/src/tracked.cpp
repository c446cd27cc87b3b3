// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/tracked.h"

#include "arrays.h"
#include "bindings.h"
#include "match.h"
#include "match/input_numbers.h"
#include "match/tracked_output.h"
#include "options.h"
#include "prepared.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

using cli::TrackedRun;

const char* const kMethod = "tracked";

TrackedRun match(const PreparedMesh& source, const PreparedMesh& target, const py::array& landmarks,
                 const py::dict& keywords, const RunOptions& how) {
  auto options = to_options<TrackedOptions>(keywords);
  cli::MatchInputs inputs = to_inputs(source, target);
  options.landmarks = cli::surface_landmarks(inputs, to_matches(landmarks, "landmarks"));
  TrackedResult result = run(how, [&](const Context& context) {
    return match_tracked(source.surface(), target.surface(), options, context);
  });
  return {std::move(inputs), report_options(kMethod, options), std::move(result)};
}

/// A map from one mesh onto another in both forms.
py::dict map_dict(const cli::MatchInput& from, const cli::MatchInput& onto, const SurfaceMap& map) {
  return to_dict(onto.mesh, cli::input_points(from, onto, map));
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

py::array_t<double> registered(const TrackedRun& run, const TrackedMap& map) {
  const cli::MatchInput& source = run.inputs.source;
  return to_array(input_pose(source.mesh, source.surface, map.registered).vertices);
}

py::list hypotheses(const TrackedRun& run) {
  py::list result;
  for (const HypothesisSummary& hypothesis : run.result.hypotheses)
    result.append(
        py::make_tuple(hypothesis.distortion, hypothesis.orientation, hypothesis.coarse_energy));
  return result;
}

std::vector<std::string> files_of(const TrackedRun& run, const SavedAs& saved) {
  return cli::tracked_files(static_cast<int>(run.result.maps.size()) - 1, saved.target_to_source);
}

void save(TrackedRun& run, const SavedAs& saved) {
  run.options.erase("landmarks_escaped");
  run.options["landmarks"] = cli::Json();
  if (!saved.landmarks.empty()) cli::set_path(run.options, "landmarks", saved.landmarks);
  run.options["target-to-source"] = saved.target_to_source;
  run.target_to_source = saved.target_to_source;
  cli::Json defaults = report_options(kMethod, TrackedOptions{});
  defaults["landmarks"] = cli::Json();
  defaults["target-to-source"] = false;
  rename(run.inputs, saved, command_line(saved, run.options, defaults));
  const py::gil_scoped_release release;
  cli::write_tracked(make_plan(saved, files_of(run, saved)), run);
}

}  // namespace

void bind_tracked(py::module_& module) {
  register_options<TrackedOptions>(module, kMethod);
  py::class_<TrackedRun>(module, "TrackedRun")
      .def_property_readonly("num_maps",
                             [](const TrackedRun& run) { return run.result.maps.size(); })
      .def("points",
           [](const TrackedRun& run, std::size_t k) {
             return map_dict(run.inputs.source, run.inputs.target,
                             run.result.maps.at(k).source_to_target);
           })
      .def("inverse_points",
           [](const TrackedRun& run, std::size_t k) {
             return map_dict(run.inputs.target, run.inputs.source,
                             run.result.maps.at(k).target_to_source);
           })
      .def("registered", [](const TrackedRun& run,
                            std::size_t k) { return registered(run, run.result.maps.at(k)); })
      .def("figures",
           [](const TrackedRun& run, std::size_t k) { return figures(run.result.maps.at(k)); })
      .def("correspondence",
           [](const TrackedRun& run) {
             return to_array(cli::input_matches(run.inputs, run.result.maps.front()));
           })
      .def_property_readonly("hypotheses", hypotheses)
      .def_property_readonly("confidence",
                             [](const TrackedRun& run) { return run.result.confidence; })
      .def_property_readonly("oriented", [](const TrackedRun& run) { return run.result.oriented; })
      .def_property_readonly("seconds",
                             [](const TrackedRun& run) { return to_dict(run.result.times); })
      .def("check_save", [](const TrackedRun& run,
                            const SavedAs& saved) { check_save(saved, files_of(run, saved)); })
      .def("save", save);
  module.def("match_tracked", match);
}

}  // namespace isomatch::python
