// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/measure/fit.h"
#include "isomatch/methods/tracked.h"
#include "isomatch/shape/shape.h"
#include "isomatch/stage_times.h"

/// Consistent correspondence over a collection of shapes.
namespace isomatch {

struct GroupOptions {
  /// Of every pair. Landmarks must be empty.
  TrackedOptions matching;
  /// The shape whose vertices are followed to all others; chosen if negative: the one that is
  /// nearest to all others, not a part, and no simpler than most.
  int template_shape = -1;
  /// Shapes most like it that each shape is matched with besides the template; 1.5 log2 N if
  /// negative.
  int neighbours = -1;
  /// Of what matching prepares of shapes and keeps for other pairs, about, in bytes.
  std::uint64_t memory = 2'000'000'000;

  /// Throws `InvalidInput` if a value is out of range or there are landmarks.
  void validate(int num_shapes) const;
};

/// What became of a pair's own map.
enum class PairUse {
  /// It agrees with those of the others.
  kAgrees,
  /// It did not, but its runner-up does, which took its place.
  kRunnerUp,
  /// Neither does: the maps of other pairs were composed instead.
  kComposed,
};

/// "agrees", "runner-up", "composed".
std::string_view to_string(PairUse use);

/// A pair that was matched.
struct GroupPair {
  int source = 0, target = 0;
  /// How badly the shapes fit, see `TrackedMap::cost`; NaN if they have too little in common.
  double cost = 0;
  /// Mean distance between where its own map, or the runner-up, leads the points of the template
  /// from the source, and where they lie on the target, over sqrt(area) of the target: how far
  /// cycles through it are from closing. NaN without a map.
  double cycle_error = 0;
  PairUse use = PairUse::kAgrees;
};

/// A shape of the collection.
struct GroupMember {
  /// Where each vertex of the template's mesh lies on the shape, none where it has no counterpart;
  /// and each vertex of the shape's mesh on the template. Maps between two members are composed of
  /// these, see `member_map`, and so close all cycles.
  SurfaceMap from_template, to_template;
  /// The template's vertices as they lie on the shape, in its coordinates: where folds were undone
  /// off the points of `from_template`, and without a counterpart as what is around them moves.
  std::vector<Point> registered;
  /// For each vertex of the template, how far apart the pairs of the shape say that it lies: root
  /// mean square distance from `from_template` over sqrt(area); 0 where it has no counterpart.
  std::vector<float> spread;
  /// Of the map from the template.
  Fit fit;

  /// Whether maps that agree lead to it. If not, the maps have no points, and nothing is
  /// registered.
  bool is_matched() const { return !registered.empty(); }
};

struct GroupResult {
  int template_shape = 0;
  /// In the order of the shapes.
  std::vector<GroupMember> members;
  /// In the order in which they were matched: the star around the template, then neighbours.
  std::vector<GroupPair> pairs;
  std::vector<StageTime> times;
};

/// Matches a collection: a star around a template, then each shape with those most like it, about
/// N log N pairs; maps that disagree with the others are replaced by their runner-up or left out;
/// then the points of all shapes are moved until all pairs agree as well as they can, robustly and
/// weighted by how well the shapes of a pair fit. Shapes may be parts. Deterministic for any number
/// of threads. Throws `InvalidInput` if an option is out of range or there are fewer than two
/// shapes, `Cancelled`.
GroupResult match_group(std::span<const Shape> shapes, const GroupOptions& options = {},
                        const Context& context = {});

/// The map from one member to another, through the template: a point of `target` for each vertex of
/// `source`, none where one is missing.
SurfaceMap member_map(std::span<const Shape> shapes, const GroupResult& group, int source,
                      int target);

}  // namespace isomatch
