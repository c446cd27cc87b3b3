// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <vector>

#include "elastic/registration.h"
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
};

struct TrackerOptions {
  ProxyOptions proxy;
  HypothesisOptions hypotheses;
  int coarse_nodes = 200;
  int finalists = 2;
  elastic::ProjectionWeights projection;
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

/// The models of both shapes. O(N log N).
std::pair<Model, Model> make_models(const Shape& source, const Shape& target,
                                    const TrackerOptions& options, const Context& context);

/// A hypothesis and its elastic energy.
struct Judged {
  Hypothesis hypothesis;
  double energy;
};

std::vector<Judged> judge(const Model& source, const Model& target,
                          std::vector<Hypothesis> hypotheses, const TrackerOptions& options,
                          const Context& context);

/// A registered hypothesis.
struct Track {
  elastic::Deformation deformation;
  elastic::Registration registration;
  /// Of a coarse, stiff registration that starts where this one ended.
  double energy = 0;
};

Track follow(const Model& source, const Model& target, const Hypothesis& hypothesis,
             const TrackerOptions& options, const Context& context);

/// A hypothesis that was followed to the end.
struct Finalist {
  Hypothesis hypothesis;
  Track track;
};

/// Follows the best of `judged`. Those that end up as the same map count once. Best first.
std::vector<Finalist> run_finals(const Model& source, const Model& target,
                                 const std::vector<Judged>& judged, const TrackerOptions& options,
                                 const Context& context);

}  // namespace isomatch::tracked
