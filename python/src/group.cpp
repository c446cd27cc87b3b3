// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/group/group.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <utility>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/measure/fit.h"
#include "isomatch/mesh/topology.h"
#include "match.h"
#include "options.h"
#include "results/folder/inputs.h"
#include "results/group/run_output.h"
#include "results/group/unmatched.h"
#include "results/page/filled_page.h"
#include "results/page/group_run_page.h"
#include "run.h"
#include "shapes.h"
#include "state.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

/// What a call asks for besides options of the matching.
struct GroupWanted {
  /// Empty and -1 if it is to be chosen.
  std::string template_name;
  int template_shape = -1;
  int neighbours = -1, points = 0;
  std::uint64_t memory = 0;
};

/// How a group is saved.
struct SavedGroup {
  std::string folder;
  /// Where it finds its meshes; those of them that were there before; and what is in the folder,
  /// seen from there, because it was given as arrays.
  std::vector<std::string> paths, inputs, arrays;
  ShapeModelOptions model;
  bool all_maps = false, page = false;
};

GroupMatch match_shapes(const GroupShapes& shapes, std::vector<std::string> names,
                        const GroupWanted& wanted, const py::dict& keywords,
                        const RunOptions& how) {
  GroupOptions options{to_options<TrackedOptions>(keywords), wanted.template_shape,
                       wanted.neighbours, wanted.memory};
  results::check_shape_names(names);
  GroupMatch group = to_group(shapes, std::move(names));
  group.run.options = results::group_options_json(options, wanted.template_name, wanted.points, {});
  run_work(how, [&](const Context& context) {
    group.run.result =
        match_group(group.run.collection.shapes, options, results::matching_part(context));
    group.vertices = results::spread_vertices(group.run, wanted.points, context);
  });
  return group;
}

template <class Scalar, class Value>
py::array_t<Scalar> of_points(const GroupMatch& group, int columns, const Value& value) {
  std::vector<decltype(value(group.run.result.members.front(), 0))> values;
  for (const GroupMember& member : group.run.result.members)
    for (const int v : group.vertices) values.push_back(value(member, v));
  std::vector<py::ssize_t> shape{std::ssize(group.run.result.members), std::ssize(group.vertices)};
  if (columns > 1) shape.push_back(columns);
  return adopt<Scalar>(std::move(values), std::move(shape));
}

/// (N, P, 3) points, not numbers where they are missing.
py::array_t<double> points_with_gaps(const GroupMatch& group) {
  std::vector<Point> all;
  for (std::vector<Point>& points : results::points_of(group.run, group.vertices).points)
    all.insert(all.end(), points.begin(), points.end());
  return adopt<double>(std::move(all),
                       {std::ssize(group.run.result.members), std::ssize(group.vertices), 3});
}

/// The same, not numbers where a shape is not matched at all.
py::array_t<double> registered(const GroupMatch& group) {
  return of_points<double>(group, 3, [](const GroupMember& member, int v) -> Point {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return member.is_matched() ? member.registered[v] : Point::Constant(kNan);
  });
}

py::array_t<float> spread_of_points(const GroupMatch& group) {
  return of_points<float>(group, 1,
                          [](const GroupMember& member, int v) { return member.spread[v]; });
}

py::list pairs(const GroupMatch& group) {
  py::list list;
  for (const auto& [source, target, cost, cycle_error, use] : group.run.result.pairs)
    list.append(py::make_tuple(source, target, cost, cycle_error, std::string(to_string(use))));
  return list;
}

bool leaves_out(const SurfaceMap& map) {
  return std::ranges::count(map, kNoFace, &SurfacePoint::face) > 0;
}

/// A map both ways between two members, and how it fits.
py::dict parts(const GroupMatch& group, int source, int target, SurfaceMap map, SurfaceMap inverse,
               const Fit& fit) {
  const std::vector<Shape>& shapes = group.run.collection.shapes;
  py::dict result;
  result["points"] = to_dict(shapes[target].mesh(), std::move(map));
  result["inverse"] = to_dict(shapes[source].mesh(), std::move(inverse));
  result["fit"] = to_dict(fit);
  return result;
}

Fit judged(const GroupMatch& group, int source, int target, const SurfaceMap& map) {
  const std::vector<Shape>& shapes = group.run.collection.shapes;
  const std::vector<GroupMember>& members = group.run.result.members;
  for (const int shape : {source, target})
    if (!members[shape].is_matched()) return members[shape].fit;
  FitOptions options;
  options.parts =
      group.run.options.value("whole", false) == false &&
      (leaves_out(members[source].from_template) || leaves_out(members[target].from_template));
  return run({py::none(), py::none()}, [&](const Context& context) {
    return judge_fit(shapes[source], shapes[target], map, options, context);
  });
}

py::dict between(const GroupMatch& group, int source, int target) {
  const std::vector<Shape>& shapes = group.run.collection.shapes;
  SurfaceMap map = member_map(shapes, group.run.result, source, target);
  SurfaceMap inverse = member_map(shapes, group.run.result, target, source);
  const Fit fit = judged(group, source, target, map);
  return parts(group, source, target, std::move(map), std::move(inverse), fit);
}

py::dict from_template(const GroupMatch& group, int shape) {
  const GroupMember& member = group.run.result.members.at(shape);
  return parts(group, group.run.result.template_shape, shape, member.from_template,
               member.to_template, member.fit);
}

py::dict to_template(const GroupMatch& group, int shape) {
  const GroupMember& member = group.run.result.members.at(shape);
  const int onto = group.run.result.template_shape;
  return parts(group, shape, onto, member.to_template, member.from_template,
               judged(group, shape, onto, member.to_template));
}

/// Without the shapes that could not be matched, as the program has it.
results::GroupRun matched_part(const GroupMatch& group) {
  results::GroupRun run = group.run;
  results::leave_out_unmatched(run);
  return run;
}

results::ResultPlan plan_of(const GroupMatch& group, const SavedGroup& saved) {
  results::ResultPlan plan{saved.folder,
                           results::group_run_files(group.run.collection.names, saved.all_maps),
                           results::InputFiles(saved.inputs), saved.arrays};
  plan.files.insert(plan.files.end(), saved.arrays.begin(), saved.arrays.end());
  plan.files.emplace_back(results::kGroupPage);
  return plan;
}

/// Fails now rather than after the arrays were written, if saving would.
void check_saving(const GroupMatch& group, const SavedGroup& saved) {
  if (saved.page) results::check_page_available();
  results::ResultPlan plan = plan_of(group, saved);
  plan.ready.clear();
  results::check_plan(plan);
}

/// The command line that makes what is saved.
std::vector<std::string> words_of(const GroupMatch& group, const SavedGroup& saved) {
  std::vector<std::string> words{"isomatch", "group"};
  words.insert(words.end(), saved.paths.begin(), saved.paths.end());
  words.insert(words.end(), {"-o", saved.folder});
  add_flags(words, group.run.options, results::group_options_json({}, {}, 0, {}));
  if (saved.all_maps) words.emplace_back("--all-maps");
  if (saved.page) words.emplace_back("--report");
  return words;
}

void save_group(GroupMatch& group, const SavedGroup& saved, const RunOptions& how) {
  group.run.options["modes"] = saved.model.modes;
  group.run.options["keep-size"] = saved.model.keep_size;
  group.run.all_maps = saved.all_maps;
  group.run.collection.paths = saved.paths;
  group.run.words = words_of(group, saved);
  group.run.working_folder = std::filesystem::current_path().string();
  run_work(how, [&](const Context& context) {
    const results::GroupRun run = matched_part(group);
    const results::GroupOutput output = results::group_output(run, group.vertices, saved.model);
    const results::Json report = results::write_group_run(plan_of(group, saved), run, output);
    if (!saved.page) return;
    results::write_group_page(
        saved.folder, report, run,
        results::group_output(run, results::spread_vertices(run, 0, context), saved.model));
  });
}

std::string page(const GroupMatch& group, bool keep_size, const RunOptions& how) {
  return run(how, [&](const Context& context) {
    const results::GroupRun run = matched_part(group);
    return results::group_run_page(
        run, results::group_output(run, results::spread_vertices(run, 0, context), {keep_size}));
  });
}

}  // namespace

void bind_group(py::module_& module) {
  py::class_<SavedGroup>(module, "SavedGroup")
      .def(py::init([](std::string folder, std::vector<std::string> paths,
                       std::vector<std::string> inputs, std::vector<std::string> arrays,
                       bool keep_size, int modes, bool all_maps, bool page) {
        return SavedGroup{std::move(folder),
                          std::move(paths),
                          std::move(inputs),
                          std::move(arrays),
                          {keep_size, modes},
                          all_maps,
                          page};
      }));
  py::class_<GroupWanted>(module, "GroupWanted")
      .def(py::init([](std::string template_name, int template_shape, int neighbours, int points,
                       std::uint64_t memory) {
        return GroupWanted{std::move(template_name), template_shape, neighbours, points, memory};
      }));
  py::class_<GroupMatch>(module, "GroupMatch")
      .def_property_readonly(
          "template", [](const GroupMatch& group) { return group.run.result.template_shape; })
      .def_property_readonly(
          "vertices", [](const GroupMatch& group) { return adopt(std::vector(group.vertices)); })
      .def_property_readonly(
          "faces",
          [](const GroupMatch& group) {
            return to_array(results::faces_between(group.run.template_mesh(), group.vertices));
          })
      .def_property_readonly("points", points_with_gaps)
      .def_property_readonly("registered", registered)
      .def_property_readonly("spread", spread_of_points)
      .def("fit", [](const GroupMatch& group,
                     int k) { return to_dict(group.run.result.members.at(k).fit); })
      .def_property_readonly("pairs", pairs)
      .def_property_readonly(
          "cycle_errors",
          [](const GroupMatch& group) { return adopt(results::cycle_errors(group.run)); })
      .def_property_readonly(
          "seconds", [](const GroupMatch& group) { return to_dict(group.run.result.times); })
      .def("between", between)
      .def("from_template", from_template)
      .def("to_template", to_template)
      .def("check_save", check_saving)
      .def("save", save_group)
      .def("page", page)
      .def_property_readonly("state", [](const GroupMatch& group) { return to_state(group); });
  module.def("check_shape_names", results::check_shape_names);
  module.def("match_group", match_shapes);
  module.def("group_of_state",
             [](const GroupShapes& shapes, std::vector<std::string> names, const py::tuple& state) {
               return to_group(shapes, std::move(names), state);
             });
}

}  // namespace isomatch::python
