// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <limits>

#include "elastic/registration.h"
#include "isomatch/maps/correspondence.h"
#include "shape/numbers.h"

/// Everything that the tracked method can be tuned by. Lengths are over sqrt(area). What a number
/// does to accuracy and time when it is halved or doubled stands in docs/results/options.md, which
/// bench/tables/options.py measures; where a comment gives no other reason, that is the reason.
namespace isomatch::tracked {

struct ProxyOptions {
  /// Vertices of the proxy, at most: as many as the sets that methods are compared on have, so that
  /// these are not simplified.
  int vertices = 5000;
  /// Nodes of the finest level: time grows with them, error falls.
  int nodes = 1600;
  /// Those of the nodes from which distances are measured, all kept in memory: as many as there are
  /// landmarks on a target, enough that one is within .035 of every point.
  int measured_nodes = 400;

  bool operator==(const ProxyOptions&) const = default;
};

/// How dense the copies of a shape are, and what is computed of them.
struct PyramidOptions {
  /// Of the copies of finer surfaces on which fields are computed, at most: distances on so many
  /// are off by .07 % where those on a million vertices are by .22 %, in a fifteenth of the time.
  int detail_vertices = 40000;
  ProxyOptions proxy{};
  /// Nodes of the levels on which hypotheses are judged, and followed at first. A limb needs some
  /// ten to bend.
  int coarse_nodes = 200, middle_nodes = 400;
  /// Eigenfunctions: the last of them oscillate over .18, the width of a limb.
  int functions = 120;
  /// Widths of the smoothing against which relief is measured: from creases of a face to muscles.
  std::array<double, elastic::kReliefs> relief_scales{0.015, 0.03, 0.06};

  bool operator==(const PyramidOptions&) const = default;
};

/// Parts of one shape that touch and were fused, as scanners and voxels do.
struct ContactOptions {
  /// Relief, at the smallest scale, of a valley that costs 1/e of what a plane costs: that of a
  /// fused contact is three times as deep.
  double valley = 0.13;
  /// Of the vertices, the deepest, from which loops are looked for, from how many of them, and from
  /// how many of the loop that is found.
  double valley_share = 0.04;
  int roots = 24, closer_roots = 8;
  /// What a loop costs at most, as length on a plane: as much as once around a wrist.
  double max_cost = 0.2;
  /// Shapes with more handles than this are not made of a few parts that touch.
  int most_handles = 12;
  /// Loops of at most this length are cut whatever they are: nothing of consequence depends on it.
  double short_loop = 0.05;
  /// How far another cut stays away from a loop.
  double avoided = 0.05;
  /// What becomes so many times as long, and longer by so much, is torn.
  double torn = 3, gap = 0.05;
};

/// Shapes of which something is missing.
struct PartialOptions {
  /// Length of the boundary, over sqrt(area), from which a shape is taken for a part: it encloses
  /// .02 of the area, if it is one circle.
  double open_boundary = 0.5;
  /// Shapes whose lengths and whose boundaries differ by at most so many times are patches that end
  /// at the same places: none is a part.
  double same_size = 1.025, same_boundary = 1.1;
  /// Weight of what distances differ by, where both may be the same on the whole shapes.
  float doubt = 0.5F;
  /// Hypotheses that are followed on the middle level: more than of whole shapes, since distances
  /// tell less.
  int entrants = 16;
  /// Rounds, iterations of the first registration, and motions that are improved, more of them for
  /// the same reason.
  int rounds = 12, first_iterations = 4, improved_poses = 150;
  /// What it costs to leave out a landmark: as much distortion.
  float landmark_price = 0.06F;
  /// What it costs to leave out area, as elastic energy and as distance of the surfaces, where it
  /// is beyond the rim of the other shape.
  double energy_price = 0.1, distance_price = 0.005;
  /// By how much more it costs where it is not.
  double contradiction_price = 4;
  /// What the cost of a motion in space is multiplied by, see `PoseOptions::price`: distances along
  /// surfaces tell less.
  double pose_price = 1.5;
  /// What is as close to the rim as this may be beyond it.
  double rim_width = 0.05;
  /// A landmark that is matched stands for what is closer than this, over sqrt(area) of the smaller
  /// shape.
  double landmark_reach = 0.15;
  /// What is farther from the other shape than this has no counterpart.
  double reach = 0.06;
  /// Of what is around a vertex that has a counterpart, at least so much has one.
  double least_inside = 0.3;
  /// What lies beyond a rim by more than this has no counterpart.
  double beyond = 0.01;
  /// A node of the target is covered by a node of the source that is as close as this many times
  /// the distance of the latter from its neighbours.
  double cover = 1.5;
  /// Means over nodes and those around them that decide what overlaps.
  int smoothing = 2;
  /// Of an overlap, pieces that are smaller than this part of it do not count.
  double min_piece = 0.05;

  bool operator==(const PartialOptions&) const = default;
};

struct SeedOptions {
  /// Extremities of a shape, at most: animals have limbs, tail, ears and snout.
  int max_extremities = 10;
  /// An extremity is farthest from everything within this distance: the tips of fingers are .03
  /// apart, ears .1.
  double extremity_radius = 0.1;
  /// Distances between matched extremities differ by at most this much: between the shapes of one
  /// class by up to .2.
  double max_difference = 0.3;
  /// Difference at which a pair of matches neither speaks for nor against a seed.
  double neutral_difference = 0.09;
  /// Three fix a map up to what is symmetric to their plane.
  int min_matches = 4;
  /// What the search keeps, and the partial matchings that it looks at: bounds of memory and time
  /// (.1 s) that ten extremities a shape do not reach.
  int max_seeds = 2000;
  int max_visits = 2000000;
  /// Evenly spread nodes that complete the tips of shapes that have too few of them for a seed.
  int spread_source_nodes = 6;
  int spread_target_nodes = 60;
};

struct GrowthOptions {
  /// A landmark chooses among targets whose distortion is within this of the least: twice the
  /// distortion of right maps.
  float slack = 0.03F;
  /// Weight of orientation against distortion: in balance where both are as large as right maps
  /// have them.
  float orientation_weight = 0.03F;
  /// Neighbours that orientation is measured against.
  int neighbours = 6;
  /// Whether orientation plays a part.
  bool orientation = true;
  /// The first landmarks, whose matches are given and stay.
  int fixed = 0;
  /// What it costs to leave out a landmark, infinite where nothing is missing, and the weight of
  /// what distances differ by where both may be the same on the whole shapes.
  float price = std::numeric_limits<float>::infinity();
  float doubt = 1;
};

/// How motions of the whole source are found, which hypotheses begin with where shapes hardly bend.
struct PoseOptions {
  /// Points whose pairs vote, and the length of those pairs: longer than what makes normals differ,
  /// no longer than what overlaps may be.
  int source_points = 150, target_points = 250;
  double shortest_pair = 0.1, longest_pair = 0.6;
  /// Differences of lengths and angles (radians) that count as the same.
  double length_bin = 0.08, angle_bin = 0.35;
  /// Motions that are looked at for each point, of all that are improved, and that are kept.
  int peaks = 5, improved = 60, kept = 16;
  int iterations = 10;
  /// Motions that differ by less than this are the same.
  double same = 0.1;
  /// What is as close as this, with normals that agree as much, lies on the target.
  double close = 0.08, min_cosine = 0.5;
  /// Where nothing lies on the target though it is no farther than `contradiction_range` and its
  /// rim is no closer than `rim_width`, the pose is contradicted: weight against what overlaps.
  double contradiction = 0.5, contradiction_range = 0.3, rim_width = 0.05;
  /// What a landmark costs that it does not match, as distortion.
  float landmark_price = 0.12F;
  /// Motions that are followed beside other hypotheses, at most, if their energy is at most so many
  /// times the least.
  int followed = 2;
  /// What the cost of a motion is multiplied by when it has been followed: without distances along
  /// the surface, points lie closer even where limbs are folded.
  double price = 6;
  double max_energy = 1.5;
  /// How much normals count as distances when the closest point is looked for.
  double normal_weight = 0.05;
};

/// A number of landmarks, and how many maps are kept.
struct GrowthStage {
  int source_landmarks;
  int target_landmarks;
  int max_maps;
};

struct HypothesisOptions {
  SeedOptions seeds;
  GrowthOptions growth;
  PoseOptions poses;
  GrowthStage coarse{40, 200, 48};
  GrowthStage fine{100, 400, 16};
  /// Near-symmetries of the target, and hypotheses that they are applied to, at most.
  GrowthStage symmetry{40, 200, 8};
  int max_twinned = 4;
  /// A map of a shape onto itself that moves landmarks less than this on average is the identity.
  float identity_move = 0.1F;
  /// Maps whose landmarks differ by less than this, root mean square, are the same hypothesis: one
  /// limb that goes elsewhere makes more.
  float same_difference = 0.07F;
  /// If extremities give fewer hypotheses than this, evenly spread nodes are matched as well: the
  /// right one may be missing where limbs touch, or where there are none.
  int enough = 4;
  /// Nodes that match.
  Correspondence landmarks;
};

/// How nodes that are out of place are found and moved, see `mended`.
struct MendingOptions {
  /// Costs beyond this multiple of the median weigh little, falling with the fourth power.
  float tolerable = 2;
  /// Of the cost, at most, remains where it is worth moving.
  float max_remaining = 0.8F;
  /// What is closer than this, rounds of refinement find by themselves.
  float min_move = 0.1F;
  elastic::RegistrationOptions registration{.first_length = 0.1,
                                            .last_length = 0.05,
                                            .anchor_steps = 4,
                                            .surface_steps = 1,
                                            .iterations = 3};
};

/// How ends of limbs that are half a turn off are found and turned, see `with_an_end_turned`.
struct TurningOptions {
  /// The end of a limb is what lies between its tip and where it is narrowest, in rings of such a
  /// width, no closer to the tip than where fingers part and no farther than half a limb.
  double shortest = 0.08, longest = 0.25, ring = 0.02;
  /// Over which length behind the end the limb is twisted, and what is held behind that.
  double twisted = 0.06, held = 0.03;
  /// An end is worth turning if its cost, registered alone, is at most so many times what it was:
  /// the limb behind it adapts only when all is registered again. Right ends cost 1.4 times as much
  /// and more. It must have moved by so much of half a turn: thin ends slide back.
  double tolerable = 1.25, least_turned = 0.5;
  /// Of the energy and of the cost over it, at most, remains of the whole where a turn is right.
  double max_remaining = 0.99;
  elastic::RegistrationOptions registration{.first_length = 0.03,
                                            .last_length = 0.01,
                                            .anchor_steps = 1,
                                            .surface_steps = 4,
                                            .iterations = 2};
};

/// How images slide along the target until both surfaces curve alike, see `slid`.
struct SlidingOptions {
  int steps = 10;
  /// Over which the curvature is averaged, least: half an edge of the proxy.
  double curvature_length = 0.01;
  /// Of the moves, against what the curvature tells: they are smooth over .06.
  double stiffness = 10;
  /// A step is at most as long as this, an edge of the proxy.
  double longest = 0.02;
};

/// How folds of the registered surface are smoothed, see `unfolded`. Lengths are in sqrt(area).
/// On 14 pairs of people and animals .62 % of the triangles are folded before and .14 % after.
struct UnfoldingOptions {
  /// Few are mended after that many.
  int rounds = 10;
  /// Patches are a few rings of triangles wide.
  int sweeps = 30;
  /// Share of the way to the target that a vertex makes each sweep, in every other round.
  double pull = 0.1;
  /// A mended triangle is worth about 1; what a vertex drifts off its image costs this, over a
  /// length.
  double drift_price = 10;
  /// The same for a vertex of the target and its image, where that is farther than `covered`.
  /// Without a price tips get shorter: a cat loses half a percent of reach, while a third fewer
  /// folds remain; at three times the price 1.7 times as many do.
  double uncovered_price = 30, covered = 0.005;
};

struct Options {
  PyramidOptions pyramid;
  HypothesisOptions hypotheses;
  PartialOptions partial;
  ContactOptions contacts;
  /// Whether something of the shapes may be missing.
  bool parts = false;
  /// Different maps that are wanted.
  int different_maps = 1;
  /// Hypotheses that are registered on the middle level (all if several maps are wanted), that are
  /// followed there, and of these on the fine level, at most, besides the first: right ones come
  /// late where limbs lie close together, but a registration tells.
  int entrants = 28, followed = 6, finalists = 2;
  /// None is followed that costs so many times as much as the best: right ones cost up to 2.9 times
  /// as much after a registration, and least after that. Of parts all are, since costs tell less.
  double begun_tolerance = 4, middle_tolerance = 1.5;
  /// Choose by how well the surfaces fit, or else by the order of the hypotheses.
  bool elastic_judging = true;
  /// What the cost of a mirror image is multiplied by: shapes that are nearly symmetric fit their
  /// own as well as themselves.
  double mirror_price = 1.1;
  /// Vertices of the surfaces that match.
  SurfaceMatches landmarks;
  /// What a right hypothesis may miss a landmark by: they are coarse, and limbs stretch.
  float landmark_slack = 0.1F;
  /// Landmarks contradict a map that costs this many times less without them: true ones that are
  /// off by an edge cost less than that.
  double contradiction = 2;
  /// How far what is around a landmark moves along, so that it arrives.
  double landmark_reach = 0.05;
  /// As long as limbs may be matched wrongly, on the middle level, and on the fine level.
  elastic::ProjectionWeights early_projection, middle_projection{.place = 0.05},
      fine_projection{.normal = 0.05, .relief = 0.1, .place = 0.05};
  /// Of motions in space: what is close is right, and places along surfaces may mean nothing.
  elastic::ProjectionWeights posed_projection{.normal = 0.03, .relief = 0, .place = 0};

  /// On the fine level.
  const elastic::ProjectionWeights& last_projection(bool posed) const {
    return posed ? posed_projection : fine_projection;
  }
  /// Of hypotheses: stiff, since a limb that is matched wrongly must cost energy.
  elastic::RegistrationOptions judging{.first_length = 0.3,
                                       .last_length = 0.04,
                                       .anchor_steps = 3,
                                       .surface_steps = 9,
                                       .iterations = 2};
  elastic::RegistrationOptions first_registration{.first_length = 0.3,
                                                  .last_length = 0.05,
                                                  .anchor_steps = 5,
                                                  .surface_steps = 5,
                                                  .iterations = 2};
  /// Rounds of alternation: a spectral step with from `first_basis` to all eigenfunctions, and a
  /// registration with lengths from the first to the last of these.
  int rounds = 10;
  int first_basis = 6;
  elastic::RegistrationOptions alternation{.first_length = 0.05,
                                           .last_length = 0.01,
                                           .anchor_steps = 2,
                                           .surface_steps = 1,
                                           .iterations = 3};
  /// On the fine level, nodes that a spectral step moves farther than this, about four times the
  /// distance between nodes, to places so many times as far, in squares, from those of their
  /// neighbours as before, stay. Where all are moved alike the step is more often right: without
  /// the second number errors on six pairs of animals rise from 1.034 to 1.055.
  double torn_move = 0.1, torn_spread = 2;
  MendingOptions mending;
  TurningOptions turning;
  /// The last of the rounds, which the target does as well, onto the source.
  int reverse_rounds = 3;
  /// Where both directions disagree by more than this, one has lost a limb, and the own one counts.
  double max_disagreement = 0.1;
  SlidingOptions sliding;
  /// The registration half way between both; with a third of these lengths errors are no smaller,
  /// and half as many triangles again are folded.
  elastic::RegistrationOptions settling{.first_length = 0.01,
                                        .last_length = 0.01,
                                        .anchor_steps = 1,
                                        .surface_steps = 0,
                                        .iterations = 3};
  UnfoldingOptions unfolding;

  /// Those of the rounds that run on the middle level: limbs find their places there in a quarter
  /// of the time.
  int middle_rounds() const { return 2 * rounds / 5; }

  /// Throws `InvalidInput` if a number is out of range.
  void validate() const;
};

}  // namespace isomatch::tracked
