// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "tracked/options.h"

/// The numbers of the tracked method as a list, for checking and for changing them one at a time.
/// What is not listed is a switch, or says what is wanted. Each function calls `visit(name,
/// number)` with names that begin with `at`; numbers are integers or not.
namespace isomatch::tracked {

template <class Visitor>
void for_each_number(elastic::ProjectionWeights& w, const std::string& at, const Visitor& visit) {
  visit(at + ".normal", w.normal);
  visit(at + ".relief", w.relief);
  visit(at + ".place", w.place);
}

template <class Visitor>
void for_each_number(elastic::RegistrationOptions& r, const std::string& at, const Visitor& visit) {
  visit(at + ".first_length", r.first_length);
  visit(at + ".last_length", r.last_length);
  visit(at + ".anchor_steps", r.anchor_steps);
  visit(at + ".surface_steps", r.surface_steps);
  visit(at + ".iterations", r.iterations);
  visit(at + ".friction", r.friction);
  visit(at + ".rotation_smoothness", r.rotation_smoothness);
  visit(at + ".min_cosine", r.min_cosine);
  visit(at + ".incompatible_weight", r.incompatible_weight);
  visit(at + ".initial_rotations", r.initial_rotations);
  visit(at + ".reach", r.reach);
}

template <class Visitor>
void for_each_number(PyramidOptions& p, const std::string& at, const Visitor& visit) {
  visit(at + ".detail_vertices", p.detail_vertices);
  visit(at + ".proxy.vertices", p.proxy.vertices);
  visit(at + ".proxy.nodes", p.proxy.nodes);
  visit(at + ".proxy.measured_nodes", p.proxy.measured_nodes);
  visit(at + ".coarse_nodes", p.coarse_nodes);
  visit(at + ".middle_nodes", p.middle_nodes);
  visit(at + ".functions", p.functions);
  for (std::size_t k = 0; k < p.relief_scales.size(); ++k)
    visit(at + ".relief_scales." + std::to_string(k), p.relief_scales[k]);
}

template <class Visitor>
void for_each_number(ContactOptions& s, const std::string& at, const Visitor& visit) {
  visit(at + ".valley", s.valley);
  visit(at + ".valley_share", s.valley_share);
  visit(at + ".roots", s.roots);
  visit(at + ".closer_roots", s.closer_roots);
  visit(at + ".max_cost", s.max_cost);
  visit(at + ".most_handles", s.most_handles);
  visit(at + ".short_loop", s.short_loop);
  visit(at + ".avoided", s.avoided);
  visit(at + ".torn", s.torn);
  visit(at + ".gap", s.gap);
}

template <class Visitor>
void for_each_number(SeedOptions& s, const std::string& at, const Visitor& visit) {
  visit(at + ".max_extremities", s.max_extremities);
  visit(at + ".extremity_radius", s.extremity_radius);
  visit(at + ".max_difference", s.max_difference);
  visit(at + ".neutral_difference", s.neutral_difference);
  visit(at + ".min_matches", s.min_matches);
  visit(at + ".max_seeds", s.max_seeds);
  visit(at + ".max_visits", s.max_visits);
  visit(at + ".spread_source_nodes", s.spread_source_nodes);
  visit(at + ".spread_target_nodes", s.spread_target_nodes);
}

template <class Visitor>
void for_each_number(GrowthStage& s, const std::string& at, const Visitor& visit) {
  visit(at + ".source_landmarks", s.source_landmarks);
  visit(at + ".target_landmarks", s.target_landmarks);
  visit(at + ".max_maps", s.max_maps);
}

template <class Visitor>
void for_each_number(PoseOptions& p, const std::string& at, const Visitor& visit) {
  visit(at + ".source_points", p.source_points);
  visit(at + ".target_points", p.target_points);
  visit(at + ".shortest_pair", p.shortest_pair);
  visit(at + ".longest_pair", p.longest_pair);
  visit(at + ".length_bin", p.length_bin);
  visit(at + ".angle_bin", p.angle_bin);
  visit(at + ".peaks", p.peaks);
  visit(at + ".improved", p.improved);
  visit(at + ".kept", p.kept);
  visit(at + ".iterations", p.iterations);
  visit(at + ".same", p.same);
  visit(at + ".close", p.close);
  visit(at + ".min_cosine", p.min_cosine);
  visit(at + ".contradiction", p.contradiction);
  visit(at + ".contradiction_range", p.contradiction_range);
  visit(at + ".rim_width", p.rim_width);
  visit(at + ".landmark_price", p.landmark_price);
  visit(at + ".followed", p.followed);
  visit(at + ".price", p.price);
  visit(at + ".max_energy", p.max_energy);
  visit(at + ".normal_weight", p.normal_weight);
}

template <class Visitor>
void for_each_number(PartialOptions& p, const std::string& at, const Visitor& visit) {
  visit(at + ".open_boundary", p.open_boundary);
  visit(at + ".same_size", p.same_size);
  visit(at + ".same_boundary", p.same_boundary);
  visit(at + ".doubt", p.doubt);
  visit(at + ".entrants", p.entrants);
  visit(at + ".rounds", p.rounds);
  visit(at + ".first_iterations", p.first_iterations);
  visit(at + ".improved_poses", p.improved_poses);
  visit(at + ".landmark_price", p.landmark_price);
  visit(at + ".energy_price", p.energy_price);
  visit(at + ".distance_price", p.distance_price);
  visit(at + ".contradiction_price", p.contradiction_price);
  visit(at + ".pose_price", p.pose_price);
  visit(at + ".rim_width", p.rim_width);
  visit(at + ".landmark_reach", p.landmark_reach);
  visit(at + ".reach", p.reach);
  visit(at + ".least_inside", p.least_inside);
  visit(at + ".beyond", p.beyond);
  visit(at + ".cover", p.cover);
  visit(at + ".smoothing", p.smoothing);
  visit(at + ".min_piece", p.min_piece);
}

template <class Visitor>
void for_each_number(HypothesisOptions& h, const std::string& at, const Visitor& visit) {
  for_each_number(h.seeds, at + ".seeds", visit);
  visit(at + ".growth.slack", h.growth.slack);
  visit(at + ".growth.orientation_weight", h.growth.orientation_weight);
  visit(at + ".growth.neighbours", h.growth.neighbours);
  for_each_number(h.poses, at + ".poses", visit);
  for_each_number(h.coarse, at + ".coarse", visit);
  for_each_number(h.fine, at + ".fine", visit);
  for_each_number(h.symmetry, at + ".symmetry", visit);
  visit(at + ".max_twinned", h.max_twinned);
  visit(at + ".identity_move", h.identity_move);
  visit(at + ".same_difference", h.same_difference);
  visit(at + ".enough", h.enough);
}

template <class Visitor>
void for_each_number(MendingOptions& m, const std::string& at, const Visitor& visit) {
  visit(at + ".tolerable", m.tolerable);
  visit(at + ".max_remaining", m.max_remaining);
  visit(at + ".min_move", m.min_move);
  for_each_number(m.registration, at + ".registration", visit);
}

template <class Visitor>
void for_each_number(TurningOptions& t, const std::string& at, const Visitor& visit) {
  visit(at + ".shortest", t.shortest);
  visit(at + ".longest", t.longest);
  visit(at + ".ring", t.ring);
  visit(at + ".twisted", t.twisted);
  visit(at + ".held", t.held);
  visit(at + ".tolerable", t.tolerable);
  visit(at + ".least_turned", t.least_turned);
  visit(at + ".max_remaining", t.max_remaining);
  for_each_number(t.registration, at + ".registration", visit);
}

template <class Visitor>
void for_each_number(UnfoldingOptions& u, const std::string& at, const Visitor& visit) {
  visit(at + ".rounds", u.rounds);
  visit(at + ".sweeps", u.sweeps);
  visit(at + ".pull", u.pull);
  visit(at + ".drift_price", u.drift_price);
  visit(at + ".uncovered_price", u.uncovered_price);
  visit(at + ".covered", u.covered);
}

template <class Visitor>
void for_each_number(Options& options, const Visitor& visit) {
  for_each_number(options.pyramid, "pyramid", visit);
  for_each_number(options.contacts, "contacts", visit);
  for_each_number(options.hypotheses, "hypotheses", visit);
  for_each_number(options.partial, "partial", visit);
  visit("entrants", options.entrants);
  visit("followed", options.followed);
  visit("begun_tolerance", options.begun_tolerance);
  visit("middle_tolerance", options.middle_tolerance);
  visit("finalists", options.finalists);
  visit("mirror_price", options.mirror_price);
  visit("landmark_slack", options.landmark_slack);
  visit("contradiction", options.contradiction);
  visit("landmark_reach", options.landmark_reach);
  for_each_number(options.early_projection, "early_projection", visit);
  for_each_number(options.middle_projection, "middle_projection", visit);
  for_each_number(options.fine_projection, "fine_projection", visit);
  for_each_number(options.posed_projection, "posed_projection", visit);
  for_each_number(options.judging, "judging", visit);
  for_each_number(options.first_registration, "first_registration", visit);
  visit("rounds", options.rounds);
  visit("first_basis", options.first_basis);
  for_each_number(options.alternation, "alternation", visit);
  for_each_number(options.mending, "mending", visit);
  for_each_number(options.turning, "turning", visit);
  visit("reverse_rounds", options.reverse_rounds);
  visit("torn_move", options.torn_move);
  visit("torn_spread", options.torn_spread);
  visit("max_disagreement", options.max_disagreement);
  visit("sliding.steps", options.sliding.steps);
  visit("sliding.curvature_length", options.sliding.curvature_length);
  visit("sliding.stiffness", options.sliding.stiffness);
  visit("sliding.longest", options.sliding.longest);
  for_each_number(options.settling, "settling", visit);
  for_each_number(options.unfolding, "unfolding", visit);
}

}  // namespace isomatch::tracked
