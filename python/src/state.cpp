// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "state.h"

#include <pybind11/stl.h>

#include <tuple>
#include <utility>
#include <vector>

#include "arrays.h"
#include "isomatch/error.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

// Names of all fields are bound: what a struct gains has to find its place here.

void check(bool fits) {
  if (!fits)
    throw InvalidInput("the match does not fit its meshes: another version of isomatch kept it");
}

py::list to_state(const std::vector<StageTime>& times) {
  py::list list;
  for (const auto& [stage, seconds, peak] : times)
    list.append(py::make_tuple(stage, seconds, peak));
  return list;
}

std::vector<StageTime> to_times(const py::handle& state) {
  std::vector<StageTime> times;
  for (const auto& [stage, seconds, peak] :
       state.cast<std::vector<std::tuple<std::string, double, double>>>())
    times.push_back({stage, seconds, peak});
  return times;
}

std::vector<int> integers(const py::handle& array) {
  return to_integers(array.cast<py::array>(), "state");
}

std::vector<double> doubles(const py::handle& array) {
  const auto values = array.cast<Doubles>();
  return {values.data(), values.data() + values.size()};
}

SurfaceMap points(const py::handle& state) {
  const auto arrays = state.cast<py::tuple>();
  return to_surface_map(arrays[0].cast<py::array>(), arrays[1].cast<py::array>());
}

py::tuple to_state(const TrackedMap& map) {
  const auto& [source_to_target, target_to_source, source_confidence, target_confidence, registered,
               energy, distance, deviation, distortion, orientation, mirrored] = map;
  return py::make_tuple(to_arrays(source_to_target), to_arrays(target_to_source),
                        to_array(registered), energy, distance, deviation, distortion, orientation,
                        mirrored, adopt(std::vector(source_confidence)),
                        adopt(std::vector(target_confidence)));
}

TrackedMap to_map(const results::MatchInputs& inputs, const py::tuple& state) {
  check(state.size() == 11);
  TrackedMap map;
  map.source_to_target = points(state[0]);
  map.target_to_source = points(state[1]);
  map.registered = to_points(state[2].cast<py::array>(), "state");
  map.energy = state[3].cast<double>();
  map.distance = state[4].cast<double>();
  map.deviation = state[5].cast<double>();
  map.distortion = state[6].cast<double>();
  map.orientation = state[7].cast<double>();
  map.mirrored = state[8].cast<bool>();
  map.source_confidence = state[9].cast<std::vector<float>>();
  map.target_confidence = state[10].cast<std::vector<float>>();
  check(std::cmp_equal(map.source_to_target.size(), inputs.source.shape.num_vertices()) &&
        std::cmp_equal(map.target_to_source.size(), inputs.target.shape.num_vertices()) &&
        map.registered.size() == map.source_to_target.size() &&
        map.source_confidence.size() == map.source_to_target.size() &&
        map.target_confidence.size() == map.target_to_source.size());
  return map;
}

py::tuple to_state(const TrackedResult& result) {
  const auto& [maps, hypotheses, ambiguity, contradicted, taken_for, oriented, times] = result;
  const auto& [source_is_part, target_is_part, scale, source_unit, target_unit, source_is_cut,
               target_is_cut] = taken_for;
  py::list map_states, summaries;
  for (const TrackedMap& map : maps) map_states.append(to_state(map));
  for (const auto& [distortion, orientation, energy] : hypotheses)
    summaries.append(py::make_tuple(distortion, orientation, energy));
  return py::make_tuple(map_states, summaries, ambiguity, to_array(contradicted), oriented,
                        to_state(times),
                        py::make_tuple(source_is_part, target_is_part, scale, source_unit,
                                       target_unit, source_is_cut, target_is_cut));
}

TrackedResult to_tracked_result(const results::MatchInputs& inputs, const py::tuple& state) {
  check(state.size() == 7);
  TrackedResult result;
  for (const py::handle map : state[0])
    result.maps.push_back(to_map(inputs, map.cast<py::tuple>()));
  for (const auto& [distortion, orientation, energy] :
       state[1].cast<std::vector<std::tuple<double, double, double>>>())
    result.hypotheses.push_back({distortion, orientation, energy});
  result.ambiguity = state[2].cast<double>();
  result.contradicted_landmarks = to_matches(state[3].cast<py::array>(), "state");
  result.oriented = state[4].cast<bool>();
  result.times = to_times(state[5]);
  const auto view =
      state[6].cast<std::tuple<bool, bool, std::string, double, double, bool, bool>>();
  result.taken_for = std::make_from_tuple<PairView>(view);
  check(!result.maps.empty());
  return result;
}

py::tuple to_state(const PaperLevel& level) {
  const auto& [source_radius, target_radius, source_bases, target_bases, many_to_one,
               many_to_one_distortion, matches, distortion, outliers_moved] = level;
  return py::make_tuple(source_radius, target_radius, source_bases, target_bases,
                        adopt(std::vector(many_to_one)), adopt(std::vector(many_to_one_distortion)),
                        to_array(matches), adopt(std::vector(distortion)), outliers_moved);
}

PaperLevel to_level(const py::tuple& state) {
  check(state.size() == 9);
  PaperLevel level;
  level.source_radius = state[0].cast<double>();
  level.target_radius = state[1].cast<double>();
  level.source_bases = state[2].cast<int>();
  level.target_bases = state[3].cast<int>();
  level.many_to_one = integers(state[4]);
  level.many_to_one_distortion = doubles(state[5]);
  level.matches = to_matches(state[6].cast<py::array>(), "state");
  level.distortion = doubles(state[7]);
  level.outliers_moved = state[8].cast<int>();
  return level;
}

py::tuple to_state(const PaperResult& result) {
  const auto& [source_bases, target_bases, levels, source_to_target, complete, times] = result;
  py::list level_states;
  for (const PaperLevel& level : levels) level_states.append(to_state(level));
  return py::make_tuple(adopt(std::vector(source_bases)), adopt(std::vector(target_bases)),
                        level_states, adopt(std::vector(source_to_target)), complete,
                        to_state(times));
}

PaperResult to_paper_result(const results::MatchInputs& inputs, const py::tuple& state) {
  check(state.size() == 6);
  PaperResult result;
  result.source_bases = integers(state[0]);
  result.target_bases = integers(state[1]);
  for (const py::handle level : state[2])
    result.levels.push_back(to_level(level.cast<py::tuple>()));
  result.source_to_target = integers(state[3]);
  result.complete = state[4].cast<bool>();
  result.times = to_times(state[5]);
  check(!result.levels.empty() &&
        std::cmp_equal(result.source_to_target.size(), inputs.source.shape.num_vertices()));
  return result;
}

std::string to_text(const Fit& fit) { return results::to_json(fit).dump(); }

Fit to_fit(const py::handle& state) {
  return results::to_fit(results::Json::parse(state.cast<std::string>()));
}

py::tuple to_state(const GroupMember& member) {
  const auto& [from_template, to_template, registered, spread, fit] = member;
  return py::make_tuple(to_arrays(from_template), to_arrays(to_template), to_array(registered),
                        adopt(std::vector(spread)), to_text(fit));
}

GroupMember to_member(const py::tuple& state) {
  check(state.size() == 5);
  return {points(state[0]), points(state[1]), to_points(state[2].cast<py::array>(), "state"),
          state[3].cast<std::vector<float>>(), to_fit(state[4])};
}

py::tuple to_state(const GroupPair& pair) {
  const auto& [source, target, cost, cycle_error, use] = pair;
  return py::make_tuple(source, target, cost, cycle_error, static_cast<int>(use));
}

GroupPair to_pair(const py::handle& state) {
  const auto [source, target, cost, cycle_error, use] =
      state.cast<std::tuple<int, int, double, double, int>>();
  check(use >= 0 && use <= static_cast<int>(PairUse::kComposed));
  return {source, target, cost, cycle_error, static_cast<PairUse>(use)};
}

py::tuple to_state(const GroupResult& result) {
  const auto& [template_shape, members, pairs, times] = result;
  py::list member_states, pair_states;
  for (const GroupMember& member : members) member_states.append(to_state(member));
  for (const GroupPair& pair : pairs) pair_states.append(to_state(pair));
  return py::make_tuple(template_shape, member_states, pair_states, to_state(times));
}

GroupResult to_group_result(const py::tuple& state) {
  check(state.size() == 4);
  GroupResult result;
  result.template_shape = state[0].cast<int>();
  for (const py::handle member : state[1])
    result.members.push_back(to_member(member.cast<py::tuple>()));
  for (const py::handle pair : state[2]) result.pairs.push_back(to_pair(pair));
  result.times = to_times(state[3]);
  return result;
}

void check_group(const GroupMatch& group) {
  const auto& [collection, result] = std::tie(group.run.collection, group.run.result);
  const auto in_range = [](int k, std::size_t size) { return k >= 0 && std::cmp_less(k, size); };
  const std::size_t count = collection.shapes.size();
  check(collection.names.size() == count && result.members.size() == count &&
        in_range(result.template_shape, count));
  const std::size_t vertices = group.run.template_mesh().vertices.size();
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [from_template, to_template, registered, spread, fit] = result.members[k];
    check_map(from_template, static_cast<int>(vertices), collection.shapes[k].mesh().num_faces());
    check_map(to_template, collection.shapes[k].num_vertices(),
              group.run.template_mesh().num_faces());
    check((registered.empty() || registered.size() == vertices) && spread.size() == vertices);
  }
  for (const GroupPair& pair : result.pairs)
    check(in_range(pair.source, count) && in_range(pair.target, count));
  for (const int v : group.vertices) check(in_range(v, vertices));
}

}  // namespace

GroupMatch to_group(const GroupShapes& shapes, std::vector<std::string> names) {
  GroupMatch group;
  for (const auto& input : shapes) {
    group.run.collection.shapes.push_back(input->shape);
    group.run.collection.paths.push_back(input->path);
  }
  group.run.collection.names = std::move(names);
  return group;
}

GroupMatch to_group(const GroupShapes& shapes, std::vector<std::string> names,
                    const py::tuple& state) {
  check(state.size() == 3);
  GroupMatch group = to_group(shapes, std::move(names));
  group.run.options = results::Json::parse(state[0].cast<std::string>());
  group.run.result = to_group_result(state[1].cast<py::tuple>());
  group.vertices = integers(state[2]);
  check_group(group);
  return group;
}

py::tuple to_state(const GroupMatch& group) {
  return py::make_tuple(group.run.options.dump(), to_state(group.run.result),
                        adopt(std::vector(group.vertices)));
}

py::tuple to_state(const TrackedMatch& match) {
  py::list fits;
  for (const Fit& fit : match.fits) fits.append(to_text(fit));
  return py::make_tuple(match.options.dump(), to_state(match.result), fits, match.has_inverse);
}

py::tuple to_state(const results::PaperRun& run) {
  return py::make_tuple(run.options.dump(), to_state(run.result), run.max_geodesics,
                        to_text(run.fit));
}

TrackedMatch to_tracked(const MatchInput& source, const MatchInput& target,
                        const py::tuple& state) {
  check(state.size() == 4);
  TrackedMatch match{
      {to_inputs(source, target), results::Json::parse(state[0].cast<std::string>())}};
  match.result = to_tracked_result(match.inputs, state[1].cast<py::tuple>());
  for (const auto& fit : state[2].cast<std::vector<std::string>>())
    match.fits.push_back(results::to_fit(results::Json::parse(fit)));
  match.has_inverse = state[3].cast<bool>();
  check(match.fits.size() == match.result.maps.size());
  return match;
}

results::PaperRun to_paper(const MatchInput& source, const MatchInput& target,
                           const py::tuple& state) {
  check(state.size() == 4);
  results::MatchInputs inputs = to_inputs(source, target);
  PaperResult result = to_paper_result(inputs, state[1].cast<py::tuple>());
  return {std::move(inputs), results::Json::parse(state[0].cast<std::string>()), std::move(result),
          state[2].cast<std::array<double, 2>>(),
          results::to_fit(results::Json::parse(state[3].cast<std::string>()))};
}

}  // namespace isomatch::python
