// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/shape/shape.h"
#include "isomatch/stage_times.h"

/// Methods that the project compares itself with, and its own, behind one interface. All of them
/// are deterministic for any number of threads.
namespace isomatch::baselines {

/// One of the maps that a method makes of a pair.
struct NamedMap {
  std::string name;
  Correspondence matches;
  /// Where each source vertex lands, if the method leads to points on triangles.
  std::optional<SurfaceMap> points;
};

/// The map by which a method is judged: at most one target vertex for every source vertex.
inline constexpr const char* kFinalMap = "final";
/// A relation in which every vertex of both surfaces occurs.
inline constexpr const char* kManyToMany = "many_to_many";

/// Isometric distortion at one level of a coarse-to-fine method, as the method itself measures it,
/// relative to the largest geodesic.
struct LevelSummary {
  int source_bases = 0, target_bases = 0;
  double many_to_one = 0, many_to_many = 0;
};

struct MethodResult {
  /// `kFinalMap` first.
  std::vector<NamedMap> maps;
  std::vector<LevelSummary> levels;
  std::vector<StageTime> times;
};

struct Method {
  std::string name;
  /// One line for the help.
  std::string about;
  std::function<MethodResult(const Shape& source, const Shape& target, const Context&)> run;
};

/// All methods: `paper`, `paper-oriented`, `tracked`, `spectral`, `gmds`, `zoomout`, each with its
/// default options.
const std::vector<Method>& methods();

/// The method of that name. Throws `InvalidInput` that lists all names if there is none.
const Method& find_method(const std::string& name);

}  // namespace isomatch::baselines
