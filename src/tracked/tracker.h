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
  double normal_weight = 0.2;
  elastic::RegistrationOptions judging{.first_length = 0.3,
                                       .last_length = 0.04,
                                       .anchor_steps = 3,
                                       .surface_steps = 9,
                                       .iterations = 2};
  elastic::RegistrationOptions first_registration;
  /// Of the alternation: in each round a length between the two, and the steps.
  elastic::RegistrationOptions next_registration{.first_length = 0.1, .last_length = 0.02, .anchor_steps = 2, .surface_steps = 1, .iterations = 3};
  int first_basis = 20, last_basis = 100;
  int rounds = 6;
  double length_fall = 1;
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
  /// Target proxy vertex of each fine node.
  std::vector<int> vertices;
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
