// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <vector>

#include "elastic/registration.h"
#include "isomatch/correspondence.h"
#include "spectral/spectral_map.h"
#include "tracked/hypotheses.h"
#include "tracked/proxy.h"
#include "tracked/transfer.h"

namespace isomatch::tracked {

/// All that is computed of one shape alone.
struct Model {
  const Shape& shape;
  UnitSurface surface;
  Proxy proxy;
  NodeGraph coarse, fine;
  spectral::Eigenbasis basis;
  /// Of the fine nodes.
  spectral::Samples samples;
  bool mirrored = false;
};

struct TrackerOptions {
  ProxyOptions proxy;
  HypothesisOptions hypotheses;
  int coarse_nodes = 200;
  /// Different maps that are wanted, and hypotheses that are followed to find them, at most.
  int different_maps = 1;
  int finalists = 2;
  /// Choose by energy, or else by the order of the hypotheses.
  bool elastic_judging = true;
  /// Maps are judged by energy times a power of their distortion. Energy alone misses limbs that
  /// are exchanged where they lie close together; distortion alone cannot tell front from back. One
  /// power for hypotheses, one for refined maps, whose energy says more.
  double distortion_power = 1, final_distortion_power = 0.33;
  /// Vertices of the surfaces that match.
  Correspondence landmarks;
  /// As long as limbs may be matched wrongly, and from then on.
  elastic::ProjectionWeights early_projection, late_projection{.place = 0.05};
  elastic::RegistrationOptions judging{.first_length = 0.3,
                                       .last_length = 0.04,
                                       .anchor_steps = 3,
                                       .surface_steps = 9,
                                       .iterations = 2};
  elastic::RegistrationOptions first_registration{
      .first_length = 0.3, .last_length = 0.05, .anchor_steps = 5, .surface_steps = 5};
  /// Rounds of alternation: a spectral step with from `first_basis` to `last_basis` eigenfunctions,
  /// and a registration with lengths from the first to the last of these.
  int rounds = 8;
  int first_basis = 6, last_basis = 100;
  elastic::RegistrationOptions alternation{.first_length = 0.05,
                                           .last_length = 0.01,
                                           .anchor_steps = 2,
                                           .surface_steps = 1,
                                           .iterations = 3};
};

/// O(N log N).
Model make_model(const Shape& shape, bool mirrored, const TrackerOptions& options,
                 const Context& context);

/// A hypothesis and its elastic energy.
struct Judged {
  Hypothesis hypothesis;
  double energy = 0;
  /// Which of the sources it starts from.
  const Model* source = nullptr;

  double cost(const TrackerOptions& options) const;
};

/// Finds hypotheses and judges them, least energy first.
std::vector<Judged> judged_hypotheses(const Model& source, const Model& target,
                                      const TrackerOptions& options, const Context& context);

void sort_by_cost(std::vector<Judged>& judged, const TrackerOptions& options);

/// A registered hypothesis.
struct Track {
  elastic::Deformation deformation;
  elastic::Registration registration;
  /// Of the nodes, with the places where they went.
  std::vector<elastic::Features> features;
  /// Of a coarse, stiff registration that starts where this one ended.
  double energy = 0;
  /// Mean isometric distortion of the first nodes.
  double distortion = 0;

  double cost(const TrackerOptions& options) const;
};

/// A hypothesis that was followed to the end.
struct Finalist {
  Judged judged;
  Track track;
};

struct Finals {
  /// Best first, all different.
  std::vector<Finalist> finalists;
  /// See `TrackedResult::confidence`.
  double confidence = 1;
};

/// Follows the best of `judged`. Those that end up as the same map count once.
Finals run_finals(const Model& target, const std::vector<Judged>& judged,
                  const TrackerOptions& options, const Context& context);

}  // namespace isomatch::tracked
