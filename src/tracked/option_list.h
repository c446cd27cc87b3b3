// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "tracked/options.h"

namespace isomatch::tracked {

/// Calls `visit(name, number)` with every number of the options that tuning may change, integer or
/// not. What is not listed is a switch, or says what is wanted.
template <class Visitor>
void for_each_number(Options& options, const Visitor& visit) {
  const auto weights = [&](const std::string& name, elastic::ProjectionWeights& w) {
    visit(name + ".normal", w.normal);
    visit(name + ".relief", w.relief);
    visit(name + ".place", w.place);
  };
  const auto registration = [&](const std::string& name, elastic::RegistrationOptions& r) {
    visit(name + ".first_length", r.first_length);
    visit(name + ".last_length", r.last_length);
    visit(name + ".anchor_steps", r.anchor_steps);
    visit(name + ".surface_steps", r.surface_steps);
    visit(name + ".iterations", r.iterations);
    visit(name + ".friction", r.friction);
    visit(name + ".rotation_smoothness", r.rotation_smoothness);
    visit(name + ".min_cosine", r.min_cosine);
    visit(name + ".incompatible_weight", r.incompatible_weight);
    visit(name + ".initial_rotations", r.initial_rotations);
  };
  const auto stage = [&](const std::string& name, GrowthStage& s) {
    visit(name + ".source_landmarks", s.source_landmarks);
    visit(name + ".target_landmarks", s.target_landmarks);
    visit(name + ".max_maps", s.max_maps);
  };
  PyramidOptions& p = options.pyramid;
  visit("pyramid.detail_vertices", p.detail_vertices);
  visit("pyramid.proxy.vertices", p.proxy.vertices);
  visit("pyramid.proxy.nodes", p.proxy.nodes);
  visit("pyramid.proxy.measured_nodes", p.proxy.measured_nodes);
  visit("pyramid.coarse_nodes", p.coarse_nodes);
  visit("pyramid.middle_nodes", p.middle_nodes);
  visit("pyramid.functions", p.functions);
  for (std::size_t k = 0; k < p.relief_scales.size(); ++k)
    visit("pyramid.relief_scales." + std::to_string(k), p.relief_scales[k]);
  HypothesisOptions& h = options.hypotheses;
  visit("hypotheses.seeds.max_extremities", h.seeds.max_extremities);
  visit("hypotheses.seeds.extremity_radius", h.seeds.extremity_radius);
  visit("hypotheses.seeds.max_difference", h.seeds.max_difference);
  visit("hypotheses.seeds.neutral_difference", h.seeds.neutral_difference);
  visit("hypotheses.seeds.min_matches", h.seeds.min_matches);
  visit("hypotheses.seeds.max_seeds", h.seeds.max_seeds);
  visit("hypotheses.seeds.max_visits", h.seeds.max_visits);
  visit("hypotheses.seeds.spread_source_nodes", h.seeds.spread_source_nodes);
  visit("hypotheses.seeds.spread_target_nodes", h.seeds.spread_target_nodes);
  visit("hypotheses.growth.slack", h.growth.slack);
  visit("hypotheses.growth.orientation_weight", h.growth.orientation_weight);
  visit("hypotheses.growth.neighbours", h.growth.neighbours);
  stage("hypotheses.coarse", h.coarse);
  stage("hypotheses.fine", h.fine);
  stage("hypotheses.symmetry", h.symmetry);
  visit("hypotheses.max_twinned", h.max_twinned);
  visit("hypotheses.identity_move", h.identity_move);
  visit("hypotheses.same_difference", h.same_difference);
  visit("hypotheses.enough", h.enough);
  visit("entrants", options.entrants);
  visit("finalists", options.finalists);
  visit("mirror_price", options.mirror_price);
  visit("landmark_slack", options.landmark_slack);
  visit("contradiction", options.contradiction);
  visit("landmark_reach", options.landmark_reach);
  weights("early_projection", options.early_projection);
  weights("middle_projection", options.middle_projection);
  weights("fine_projection", options.fine_projection);
  registration("judging", options.judging);
  registration("first_registration", options.first_registration);
  visit("rounds", options.rounds);
  visit("first_basis", options.first_basis);
  registration("alternation", options.alternation);
  visit("mending.tolerable", options.mending.tolerable);
  visit("mending.max_remaining", options.mending.max_remaining);
  visit("mending.min_move", options.mending.min_move);
  registration("mending.registration", options.mending.registration);
  visit("reverse_rounds", options.reverse_rounds);
  visit("max_disagreement", options.max_disagreement);
  registration("settling", options.settling);
}

}  // namespace isomatch::tracked
