// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "elastic/registration.h"
#include "isomatch/maps/correspondence.h"
#include "shape/numbers.h"

namespace isomatch::tracked {

struct ProxyOptions {
  /// Vertices of the proxy, nodes, and those of the nodes from which distances are measured, at
  /// most.
  int vertices = 5000;
  int nodes = 1600;
  int measured_nodes = 500;

  bool operator==(const ProxyOptions&) const = default;
};

/// How dense the copies of a shape are, and what is computed of them.
struct PyramidOptions {
  /// Of the copies of finer surfaces on which fields are computed, at most.
  int detail_vertices = 40000;
  ProxyOptions proxy;
  /// Nodes of the levels; the finest has those of the proxy.
  int coarse_nodes = 200, middle_nodes = 400;
  /// Eigenfunctions.
  int functions = 120;

  bool operator==(const PyramidOptions&) const = default;
};

struct SeedOptions {
  /// Extremities of a shape, at most.
  int max_extremities = 10;
  /// An extremity is farthest from everything within this distance.
  double extremity_radius = 0.1;
  /// Distances between matched extremities differ by at most this much.
  double max_difference = 0.3;
  /// Difference at which a pair of matches neither speaks for nor against a seed.
  double neutral_difference = 0.09;
  int min_matches = 4;
  int max_seeds = 2000;
  /// Partial matchings that are looked at.
  int max_visits = 2000000;
  /// Evenly spread nodes that complete the tips of shapes that have too few of them for a seed.
  int spread_source_nodes = 6;
  int spread_target_nodes = 60;
};

struct GrowthOptions {
  /// A landmark chooses among targets whose distortion is within this of the least.
  float slack = 0.03F;
  /// Weight of orientation against distortion.
  float orientation_weight = 0.03F;
  /// Neighbours that orientation is measured against.
  int neighbours = 6;
  /// Whether orientation plays a part.
  bool orientation = true;
  /// The first landmarks, whose matches are given and stay.
  int fixed = 0;
};

/// A number of landmarks and how different two maps of them are before they count as two.
struct GrowthStage {
  int source_landmarks;
  int target_landmarks;
  int max_maps;
};

struct HypothesisOptions {
  SeedOptions seeds;
  GrowthOptions growth;
  GrowthStage coarse{40, 200, 48};
  GrowthStage fine{100, 400, 16};
  /// Near-symmetries of the target, and hypotheses that they are applied to, at most.
  GrowthStage symmetry{40, 200, 8};
  int max_twinned = 4;
  /// Maps whose landmarks differ by less than this, root mean square, are the same hypothesis.
  float same_difference = 0.07F;
  /// If extremities give fewer hypotheses than this, evenly spread nodes are matched as well: the
  /// right one may be missing where limbs touch, or where there are none.
  int enough = 4;
  /// Nodes that match.
  Correspondence landmarks;
};

/// Everything that the tracked method can be tuned by.
struct Options {
  PyramidOptions pyramid;
  HypothesisOptions hypotheses;
  /// Different maps that are wanted.
  int different_maps = 1;
  /// Hypotheses that are followed on the middle level, all if several maps are wanted, and of these
  /// on the fine level, at most, besides the first.
  int entrants = 6, finalists = 2;
  /// Choose by how well the surfaces fit, or else by the order of the hypotheses.
  bool elastic_judging = true;
  /// Vertices of the surfaces that match.
  SurfaceMatches landmarks;
  /// As long as limbs may be matched wrongly, on the middle level, and on the fine level.
  elastic::ProjectionWeights early_projection, middle_projection{.place = 0.05},
      fine_projection{.normal = 0.05, .relief = 0.1, .place = 0.05};
  elastic::RegistrationOptions judging{.first_length = 0.3,
                                       .last_length = 0.04,
                                       .anchor_steps = 3,
                                       .surface_steps = 9,
                                       .iterations = 2};
  elastic::RegistrationOptions first_registration{
      .first_length = 0.3, .last_length = 0.05, .anchor_steps = 5, .surface_steps = 5};
  /// Rounds of alternation: a spectral step with from `first_basis` to all eigenfunctions, and a
  /// registration with lengths from the first to the last of these.
  int rounds = 12;
  int first_basis = 6;
  elastic::RegistrationOptions alternation{.first_length = 0.05,
                                           .last_length = 0.01,
                                           .anchor_steps = 2,
                                           .surface_steps = 1,
                                           .iterations = 3};
  /// After nodes of the middle level were moved because they were out of place.
  elastic::RegistrationOptions mending{.first_length = 0.1,
                                       .last_length = 0.05,
                                       .anchor_steps = 4,
                                       .surface_steps = 1,
                                       .iterations = 3};
  /// The last of the rounds, which the target does as well, onto the source; and the registration
  /// half way between both.
  int reverse_rounds = 3;
  elastic::RegistrationOptions settling{.first_length = 0.003,
                                        .last_length = 0.003,
                                        .anchor_steps = 1,
                                        .surface_steps = 0,
                                        .iterations = 3};

  /// Those of the rounds that run on the middle level, a third.
  int middle_rounds() const { return rounds / 3; }
};

}  // namespace isomatch::tracked
