// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/surface_map.h"
#include "shape/surface.h"

namespace isomatch::group {

/// Where each vertex of the template's surface lies on the surface of a shape; no face where it has
/// no counterpart.
using Places = SurfaceMap;

/// A map between two shapes of a group, in the numbers of their surfaces, with how much it counts.
struct WeightedMap {
  int from, onto;
  const SurfaceMap* map;
  double weight;
};

/// What a map says of a place.
struct Said;

/// The maps of a group, by the shape that they lead to.
class MapGraph {
 public:
  MapGraph(std::vector<const Surface*> surfaces, const std::vector<WeightedMap>& maps);

  int size() const { return static_cast<int>(surfaces_.size()); }
  const std::vector<const Surface*>& surfaces() const { return surfaces_; }

  /// Places on all shapes, each from the template along the maps that are best together: weights
  /// are inverse variances, which add up along a way. Shapes that no way leads to have none.
  std::vector<Places> followed_from(int template_shape) const;
  /// Moves the places on all shapes but the template, so often, to where the maps from the other
  /// shapes say that they are: their geometric median, which a few wrong maps do not move far. A
  /// place is missing where most of the maps that could have it do not.
  void agree(std::vector<Places>& places, int template_shape, int rounds,
             const Context& context) const;
  /// Root mean square distance of the places on a shape from what the maps to it say, for each.
  std::vector<float> spread(const std::vector<Places>& places, int shape) const;
  /// Mean distance between where a map leads the places of `from` and those of `onto`; infinite if
  /// there are none.
  double disagreement(const std::vector<Places>& places, int from, int onto,
                      const SurfaceMap& map) const;

 private:
  Places carried(const Places& places, int from, int onto, const SurfaceMap& map) const;
  Places agreed(const std::vector<Places>& places, int shape) const;
  std::vector<Said> said_of(const std::vector<Places>& places, int shape, int point) const;

  std::vector<const Surface*> surfaces_;
  /// Those that lead to each shape.
  std::vector<std::vector<WeightedMap>> onto_;
};

}  // namespace isomatch::group
