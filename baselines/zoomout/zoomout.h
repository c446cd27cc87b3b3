// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/stage_times.h"
#include "shape/metric_surface.h"
#include "zoomout/functional_map.h"

namespace isomatch::baselines {

struct ZoomOutOptions {
  /// Eigenfunctions that wave kernel signatures are made of.
  int signature_functions = 200;
  /// Energies of the signatures, and of how many of these each one is a descriptor.
  int energies = 100, energy_step = 20;
  FunctionalMapWeights weights;
  /// Size of the first functional map and of the last one, and by how much it grows.
  int first_size = 20, last_size = 200, step = 5;
  /// Rounds of spectral ICP at the first size (Ovsjanikov et al. 2012).
  int first_rounds = 10;
  /// Vertices of each shape, evenly spread, between which the map is upsampled.
  int samples = 1000;

  /// Throws `InvalidInput` if a value is out of range.
  void validate() const;
};

struct ZoomOutResult {
  /// A target vertex for every source vertex of the surfaces.
  VertexMap source_to_target;
  std::vector<StageTime> times;
};

/// Functional maps from wave kernel signatures with the orientation-preserving term (Ren et al.
/// 2018), refined by ZoomOut (Melzi et al. 2019) in its accelerated form, on samples; the last
/// nearest neighbours are those of all vertices. Needs no landmarks. Surfaces must be oriented
/// alike. Throws `InvalidInput` if an option is out of range or a surface has too few vertices.
ZoomOutResult match_zoomout(const MetricSurface& source, const MetricSurface& target,
                            const ZoomOutOptions& options = {}, const Context& context = {});

}  // namespace isomatch::baselines
