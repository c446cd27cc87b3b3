// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <concepts>
#include <type_traits>

#include "isomatch/carry/map_inversion.h"
#include "isomatch/carry/pose_transfer.h"
#include "isomatch/carry/texture_transfer.h"
#include "isomatch/geodesics/geodesics.h"
#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/synth.h"
#include "isomatch/methods/paper.h"
#include "isomatch/methods/tracked.h"

/// The options of every stage as lists, from which command line flags, Python keywords and reports
/// derive: `for_each_option(options, visit)` calls `visit(name, value, meaning)` for each field in
/// order. `options` may be const. The name is that of the field; those of nested structs stand in
/// one list with the others, no name twice. Values that numbers and words cannot give, such as
/// landmarks, are left out.
///
/// A struct that gains a field does not compile here until the list has it too.
namespace isomatch {

template <class Options, class Struct>
concept OptionsOf = std::same_as<std::remove_const_t<Options>, Struct>;

template <OptionsOf<GeodesicOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [arcs, window_angle] = options;
  visit("arcs", arcs, "edges, as in the paper, or visibility: straight lines across triangles");
  visit("window_angle", window_angle, "angle in degrees below which visibility is not divided");
}

template <OptionsOf<SaliencyOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [integral_points, curvature_scale] = options;
  visit("integral_points", integral_points,
        "points that stand for the surface in the integral geodesic distance");
  visit("curvature_scale", curvature_scale, "smoothing of the Gaussian curvature, over sqrt(area)");
}

template <OptionsOf<RadiusOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [radius_factor, max_coarse_bases, max_radius_ratio, full_share] = options;
  visit("radius_factor", radius_factor,
        "sampling radius over that of a disk of the largest patch's area");
  visit("max_coarse_bases", max_coarse_bases,
        "most base vertices at level 0 (M0 of the paper: 5 to 9)");
  visit("max_radius_ratio", max_radius_ratio,
        "largest ratio of the sampling radii of consecutive levels");
  visit("full_share", full_share, "share of the vertices from which on a level takes all");
}

template <OptionsOf<PatchMatchingOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [max_patch_bases, max_search_nodes] = options;
  visit("max_patch_bases", max_patch_bases,
        "base vertices of a patch in the combinatorial search (cap of M)");
  visit("max_search_nodes", max_search_nodes,
        "partial matchings that one combinatorial search looks at");
}

template <OptionsOf<MergingOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [outlier_factor, candidate_radius, relaxation_rounds, outlier_rounds] = options;
  visit("outlier_factor", outlier_factor, "outliers exceed this multiple of the mean distortion");
  visit("candidate_radius", candidate_radius,
        "merging looks this far around proposed matches, over the sampling radius");
  visit("relaxation_rounds", relaxation_rounds, "repetitions of merging's step 1");
  visit("outlier_rounds", outlier_rounds, "most repetitions of merging's steps 2 and 3");
}

template <OptionsOf<PaperOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [saliency, radii, patches, merging, list_size, coarse_candidates, candidate_levels,
         keep_orientation, max_levels] = options;
  for_each_option(saliency, visit);
  for_each_option(radii, visit);
  for_each_option(patches, visit);
  for_each_option(merging, visit);
  visit("list_size", list_size, "matches that distortion is measured against (E)");
  visit("coarse_candidates", coarse_candidates, "matchings of level 0 that are carried on");
  visit("candidate_levels", candidate_levels, "level at which the least distorted candidate stays");
  visit("keep_orientation", keep_orientation,
        "let a candidate stay that does not exchange left and right");
  visit("max_levels", max_levels, "last level K; earlier if every vertex is matched");
}

template <OptionsOf<TrackedOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [whole, scale, allow_reflection, orientation, elastic_judging, refinement, alternatives,
         landmarks] = options;
  visit("whole", whole, "nothing of the shapes is missing, whatever their boundaries");
  visit(
      "scale", scale,
      "what makes sizes alike: same (units), area, or auto: area of whole shapes, units of parts");
  visit("allow_reflection", allow_reflection,
        "try to match the mirror image of the source as well");
  visit("orientation", orientation,
        "grow hypotheses by orientation too, not by distances along the surface alone");
  visit("elastic_judging", elastic_judging,
        "choose by elastic energy instead of distortion and orientation");
  visit("refinement", refinement, "go on after a first, coarse registration");
  visit("alternatives", alternatives, "maps to give besides the best one");
}

template <OptionsOf<TruthOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [max_samples] = options;
  visit("max_samples", max_samples, "most errors that are computed, evenly spaced in their order");
}

template <OptionsOf<DistortionOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [list_size] = options;
  visit("list_size", list_size, "matches that distortion is measured against (E)");
}

template <OptionsOf<OrientationOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [landmarks, min_distance, max_distance] = options;
  visit("landmarks", landmarks, "evenly spaced matches that vote");
  visit("min_distance", min_distance, "how near a landmark looks at others, over sqrt(area)");
  visit("max_distance", max_distance, "how far a landmark looks at others, over sqrt(area)");
}

template <OptionsOf<InversionOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [max_distance, normal_weight] = options;
  visit("max_distance", max_distance,
        "farther than this from what the source covers there is no point, over sqrt(area)");
  visit("normal_weight", normal_weight,
        "how much the angle between normals counts against distance, over sqrt(area)");
}

template <OptionsOf<TextureTransferOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [cut_seams] = options;
  visit("cut_seams", cut_seams, "cut faces along seams, which adds vertices at the end");
}

template <OptionsOf<PoseTransferOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [same_rest_pose] = options;
  visit("same_rest_pose", same_rest_pose,
        "both meshes are in the same pose: carry how the frames differ from it");
}

template <OptionsOf<SynthOptions> Options, class Visitor>
void for_each_option(Options& options, const Visitor& visit) {
  auto& [shape, vertices, pose, seed, cut, holes] = options;
  visit("shape", shape, "what to make; creature");
  visit("vertices", vertices, "wanted number of vertices, met within 2 %");
  visit("pose", pose, "0 is the symmetric rest pose, every other number a pose of its own");
  visit("seed", seed, "decides the shape");
  visit("cut", cut, "share of the area that is removed, beyond a plane of random direction");
  visit("holes", holes, "round holes at random places");
}

}  // namespace isomatch
