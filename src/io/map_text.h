// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>

#include "isomatch/io/map_file.h"

/// The text forms of maps, see map_file.h. Where `numbering` is not given, it is found out and put
/// into `used`.
namespace isomatch {

VertexMap read_vertex_map(const std::string& path, const MapChecks& checks,
                          std::optional<Numbering> numbering, MapReadReport& used);
Correspondence read_pairs(const std::string& path, const MapChecks& checks,
                          std::optional<Numbering> numbering, MapReadReport& used);
SurfaceMap read_points(const std::string& path, const MapChecks& checks, Numbering numbering);

/// Numbered from `first`.
void write_vertex_map(const std::string& path, const VertexMap& map, int first);
void write_points(const std::string& path, const SurfaceMap& map, int first);

}  // namespace isomatch
