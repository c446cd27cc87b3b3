// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "json.h"

#include <optional>

namespace isomatch::cli {
namespace {

Json to_json(const Connectivity& connectivity) {
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

}  // namespace

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
          {"given", to_json(diagnosis.given)},
          {"surface", to_json(diagnosis.surface)},
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

}  // namespace isomatch::cli
