// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/map_file.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "io/input_file.h"
#include "io/line_writer.h"
#include "io/map_arrays.h"
#include "io/map_text.h"
#include "io/whole_number.h"
#include "isomatch/error.h"

namespace isomatch {
namespace {

bool has_ending(const std::string& path, std::string_view ending) {
  return path.size() >= ending.size() &&
         equal_ignoring_case(std::string_view(path).substr(path.size() - ending.size()), ending);
}

void check_name(const std::string& path) {
  if (!is_map_file_name(path))
    throw BadFile(path, "the ending is not that of a map: .txt .map .vts .bary.txt .npz");
}

}  // namespace

bool is_point_map_file_name(const std::string& path) { return has_ending(path, ".bary.txt"); }

bool is_vts_file_name(const std::string& path) { return has_ending(path, ".vts"); }

bool is_map_file_name(const std::string& path) {
  return std::ranges::any_of(std::array{".txt", ".map", ".vts", ".npz"},
                             [&](const char* ending) { return has_ending(path, ending); });
}

bool lists_pairs(const std::string& path) {
  if (is_point_map_file_name(path) || !(has_ending(path, ".txt") || has_ending(path, ".map")))
    return false;
  const InputFile file(path);
  TextCursor cursor(file, kNumberLines);
  if (!cursor.find_content()) return false;
  cursor.word();
  return !cursor.at_line_end();
}

void check_map_output(const std::string& path) {
  check_name(path);
  const AtomicFile attempt(path);
}

MapContent read_map(const std::string& path, const MapChecks& checks,
                    std::optional<Numbering> numbering, MapReadReport* report) {
  check_name(path);
  MapReadReport used{numbering.value_or(Numbering::kFromZero), false};
  MapContent map;
  if (is_point_map_file_name(path)) {
    map.points = read_points(path, checks, used.numbering);
  } else if (has_ending(path, ".npz")) {
    used.numbering = Numbering::kFromZero;
    map = read_map_arrays(path, checks);
  } else {
    if (is_vts_file_name(path)) numbering = Numbering::kFromOne;
    map.source_to_target = read_vertex_map(path, checks, numbering, used);
  }
  if (report) *report = used;
  return map;
}

MatchContent read_matches(const std::string& path, const MapChecks& checks,
                          std::optional<Numbering> numbering, MapReadReport* report) {
  check_name(path);
  if (!lists_pairs(path)) {
    MapContent map = read_map(path, checks, numbering, report);
    return {to_correspondence(map.source_to_target), std::move(map.points)};
  }
  MapReadReport used;
  MatchContent content{read_pairs(path, checks, numbering, used), {}};
  if (report) *report = used;
  return content;
}

std::vector<int> read_ground_truth(const std::string& path, std::optional<int> num_vertices) {
  std::vector<int> vertices =
      read_map(path, {std::nullopt, num_vertices, std::nullopt}).source_to_target;
  if (vertices.empty()) throw BadFile(path, "points on triangles are no template's vertices");
  return vertices;
}

void write_map(const std::string& path, const MapContent& map, Numbering numbering) {
  check_name(path);
  const bool is_points = is_point_map_file_name(path), is_arrays = has_ending(path, ".npz");
  const VertexMap& vertices = map.source_to_target;
  if (is_arrays ? vertices.empty() && map.points.empty()
                : (is_points ? map.points.empty() : vertices.empty()))
    throw InvalidInput("write_map: this form of the map is not known");
  const int first = static_cast<int>(numbering);
  if (is_arrays) {
    write_map_arrays(path, map);
  } else if (is_points) {
    write_points(path, map.points, first);
  } else if (!is_vts_file_name(path)) {
    write_vertex_map(path, vertices, first);
  } else {
    if (std::ranges::find(vertices, kUnmatched) != vertices.end())
      throw InvalidInput(
          "a map with unmatched vertices is not written as .vts: few programs know its 0");
    write_vertex_map(path, vertices, 1);
  }
}

void write_ground_truth(const std::string& path, const std::vector<int>& vertices) {
  if (is_vts_file_name(path) && !vertices.empty())
    write_vertex_map(path, vertices, 1);
  else
    write_map(path, {.source_to_target = vertices});
}

void write_correspondence(const std::string& path, const Correspondence& correspondence,
                          std::span<const double> d_iso) {
  if (!d_iso.empty() && d_iso.size() != correspondence.size())
    throw InvalidInput("write_correspondence needs a distortion for every match or none");
  AtomicFile file(path);
  LineWriter lines(file);
  for (std::size_t i = 0; i < correspondence.size(); ++i) {
    const auto [source, target] = correspondence[i];
    if (d_iso.empty())
      lines.add("{} {}", source, target);
    else
      lines.add("{} {} {}", source, target, d_iso[i]);
  }
  file.commit();
}

}  // namespace isomatch
