// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace isomatch::results {
namespace {

Json connectivity_json(const Connectivity& connectivity) {
  const std::optional<int> genus = connectivity.genus();
  return {{"vertices", connectivity.vertices},
          {"edges", connectivity.edges},
          {"faces", connectivity.faces},
          {"components", connectivity.components},
          {"boundary_edges", connectivity.boundary_edges},
          {"boundary_loops", connectivity.boundary_loops},
          {"nonmanifold_edges", connectivity.nonmanifold_edges},
          {"nonmanifold_vertices", connectivity.nonmanifold_vertices},
          {"inconsistent_edges", connectivity.inconsistent_edges},
          {"orientable", connectivity.orientable},
          {"euler_characteristic", connectivity.euler_characteristic()},
          {"genus", genus ? Json(*genus) : Json()}};
}

constexpr const char* kEscaped = "_escaped";

/// `text` with U+FFFD for what is not UTF-8.
std::string displayed(const std::string& text) {
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool is_utf8(const std::string& text) { return displayed(text) == text; }

std::string escaped(const std::string& path) {
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte == '%' || byte > 0x7e ? fmt::format("%{:02X}", byte) : std::string(1, c);
  }
  return result;
}

std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = text.data() + i + 1;
    if (text[i] == '%' && text.size() - i > 2 &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      result += static_cast<char>(byte);
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

}  // namespace

void set_path(Json& object, const std::string& key, const std::string& path) {
  object[key] = displayed(path);
  if (!is_utf8(path)) object[key + kEscaped] = escaped(path);
}

void set_paths(Json& object, const std::string& key, const std::vector<std::string>& paths) {
  Json shown = Json::array(), hidden = Json::array();
  for (const std::string& path : paths) {
    shown.push_back(displayed(path));
    hidden.push_back(escaped(path));
  }
  object[key] = shown;
  if (!std::ranges::all_of(paths, is_utf8)) object[key + kEscaped] = hidden;
}

std::string get_path(const Json& object, const std::string& key) {
  const auto found = object.find(key + kEscaped);
  if (found == object.end()) return object.at(key).get<std::string>();
  return unescaped(found->get<std::string>());
}

std::vector<std::string> get_paths(const Json& object, const std::string& key) {
  const auto found = object.find(key + kEscaped);
  if (found == object.end()) return object.at(key).get<std::vector<std::string>>();
  auto paths = found->get<std::vector<std::string>>();
  for (std::string& path : paths) path = unescaped(path);
  return paths;
}

Json to_json(const MeshDiagnosis& diagnosis) {
  return {{"vertices", diagnosis.vertices},
          {"faces", diagnosis.faces},
          {"area", diagnosis.area},
          {"degenerate_faces", diagnosis.degenerate_faces},
          {"duplicate_faces", diagnosis.duplicate_faces},
          {"unreferenced_vertices", diagnosis.unreferenced_vertices},
          {"duplicate_vertices", diagnosis.duplicate_vertices},
          {"not_finite_vertices", diagnosis.not_finite_vertices},
          {"stray_vertices", diagnosis.stray_vertices},
          {"near_seam_vertices", diagnosis.near_seam_vertices},
          {"given", connectivity_json(diagnosis.given)},
          {"surface", connectivity_json(diagnosis.surface)},
          {"components", diagnosis.components},
          {"joined_edges", diagnosis.joined_edges},
          {"matchable_vertices", diagnosis.matchable_vertices},
          {"matchable_area_share", diagnosis.matchable_area_share},
          {"min_edge", diagnosis.min_edge},
          {"mean_edge", diagnosis.mean_edge},
          {"max_edge", diagnosis.max_edge},
          {"long_edges", diagnosis.long_edges},
          {"warnings", diagnosis.warnings()}};
}

}  // namespace isomatch::results
