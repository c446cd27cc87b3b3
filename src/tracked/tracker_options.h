// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "elastic/registration.h"
#include "isomatch/maps/correspondence.h"
#include "tracked/hypotheses.h"
#include "tracked/proxy.h"

namespace isomatch::tracked {

struct TrackerOptions {
  /// Of the copies of finer surfaces on which fields are computed, at most.
  int detail_vertices = 40000;
  ProxyOptions proxy;
  HypothesisOptions hypotheses;
  /// Nodes of the levels; the finest has those of the proxy.
  int coarse_nodes = 200, middle_nodes = 400;
  /// Different maps that are wanted.
  int different_maps = 1;
  /// Hypotheses that are followed on the middle level, all if several maps are wanted, and of these
  /// on the fine level, at most, besides the first.
  int entrants = 6, finalists = 2;
  /// Choose by how well the surfaces fit, or else by the order of the hypotheses.
  bool elastic_judging = true;
  /// Vertices of the surfaces that match.
  Correspondence landmarks;
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
  /// Rounds of alternation: a spectral step with from `first_basis` to `last_basis` eigenfunctions,
  /// and a registration with lengths from the first to the last of these.
  int rounds = 12;
  int first_basis = 6, last_basis = 120;
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
