// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/paper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "isomatch/error.h"
#include "isomatch/measure/metrics.h"
#include "paper/patch_pairs.h"
#include "paper/saliency.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {

using paper::match_patch_pairs;
using paper::match_whole_surfaces;
using paper::MatchedLevel;
using paper::PatchMatching;

namespace {

/// The orders in which vertices become base vertices (Section 3).
struct SamplingOrders {
  std::vector<int> coarsest, finer;
};

SamplingOrders sampling_orders(const MetricSurface& shape, const SaliencyOptions& options,
                               const Context& context) {
  return {descending_order(integral_geodesic_distance(shape, options, context)),
          descending_order(gaussian_curvature(shape, options))};
}

float radius_of_area(double area, const RadiusOptions& options) {
  return static_cast<float>(options.radius_factor * std::sqrt(area / std::numbers::pi));
}

float next_radius(const MetricSurface& shape, const BaseSampling& previous,
                  const RadiusOptions& options) {
  const double share = static_cast<double>(previous.bases.size()) / shape.num_vertices();
  if (share >= options.full_share) return 0;
  return std::min(radius_of_area(previous.largest_patch_area, options),
                  static_cast<float>(options.max_radius_ratio) * previous.radius);
}

/// S(0) and T(0): the smallest radii of the rule's ratio that give few enough bases on both.
void sample_coarsest(const MetricSurface& source, const MetricSurface& target,
                     const SamplingOrders& source_orders, const SamplingOrders& target_orders,
                     const RadiusOptions& options, const Context& context, SampledLevel& level) {
  constexpr float kGrowth = 1.02f;
  float source_radius = radius_of_area(1, options);
  float target_radius = radius_of_area(1, options);
  for (;; source_radius *= kGrowth, target_radius *= kGrowth) {
    context.check_stop();
    level.source.sampling =
        sample_bases(source, source_orders.coarsest, {}, source_radius, context);
    level.target.sampling =
        sample_bases(target, target_orders.coarsest, {}, target_radius, context);
    if (std::max(level.source.num_bases(), level.target.num_bases()) <= options.max_coarse_bases)
      return;
  }
}

ShapeLevel finer_shape_level(const MetricSurface& shape, const SamplingOrders& orders,
                             const ShapeLevel& previous, const RadiusOptions& options,
                             const Context& context) {
  ShapeLevel level;
  level.sampling = sample_bases(shape, orders.finer, previous.sampling.bases,
                                next_radius(shape, previous.sampling, options), context);
  level.neighbourhoods =
      BaseNeighbourhoods(shape, level.sampling.bases, 2 * previous.sampling.radius, context);
  return level;
}

BaseNeighbourhoods all_distances(const MetricSurface& shape, const ShapeLevel& level,
                                 const Context& context) {
  return {shape, level.sampling.bases, std::numeric_limits<float>::max(), context};
}

Correspondence union_of(const std::vector<PatchMatching>& patches) {
  Correspondence all;
  for (const PatchMatching& patch : patches)
    all.insert(all.end(), patch.matches.begin(), patch.matches.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// A chain of matched levels that began with one of the matchings of level 0.
struct Hypothesis {
  std::vector<MatchedLevel> levels;

  double distortion() const { return summarize(levels.back().merge.distortion).mean; }
};

/// Samples and matches level by level.
class Descent {
 public:
  Descent(const MetricSurface& source, const MetricSurface& target, const PaperOptions& options,
          const Context& context, std::vector<StageTime>& times)
      : source_(source),
        target_(target),
        options_(options),
        context_(context),
        times_(times),
        source_fields_(source),
        target_fields_(target) {
    const StageTimer timer(times_, "saliency");
    source_orders_ = sampling_orders(source, options.saliency, context);
    target_orders_ = sampling_orders(target, options.saliency, context);
  }

  /// Section 3.
  void sample_level() {
    const StageTimer timer(times_, "sampling");
    if (sampled_.empty()) {
      sampled_.push_back(coarsest_level());
    } else {
      sampled_.push_back(finer_level(sampled_.back()));
    }
  }

  /// Section 4.1 at level 0.
  std::vector<Hypothesis> match_coarsest() {
    const SampledLevel& level = sampled_.front();
    std::vector<Hypothesis> hypotheses;
    for (Correspondence& matches : coarsest_matchings(level)) {
      std::vector<PatchMatching> patches{{{0, 0}, std::move(matches)}};
      hypotheses.push_back({{merged(level, std::move(patches), {})}});
    }
    return hypotheses;
  }

  /// Sections 4.1 and 4.2 at the level that was sampled last.
  void match_level(Hypothesis& hypothesis) {
    const SampledLevel& coarser = *(sampled_.end() - 2);
    const SampledLevel& level = sampled_.back();
    const MatchedLevel& previous = hypothesis.levels.back();
    const std::vector<int>& inherited = previous.merge.merged.target_of_source;
    hypothesis.levels.push_back(
        merged(level, matched_patches(coarser, level, previous), inherited));
  }

  bool complete() const {
    return sampled_.back().source.num_bases() == source_.num_vertices() &&
           sampled_.back().target.num_bases() == target_.num_vertices();
  }

  /// Share of the levels that is done: they are about equally many for each doubling of the bases.
  double progress() const {
    const double bases = sampled_.back().source.num_bases();
    return std::log(bases) / std::log(std::max(2, source_.num_vertices()));
  }

  const std::vector<SampledLevel>& sampled() const { return sampled_; }

 private:
  SampledLevel coarsest_level() const {
    SampledLevel level;
    sample_coarsest(source_, target_, source_orders_, target_orders_, options_.radii, context_,
                    level);
    level.source.neighbourhoods = all_distances(source_, level.source, context_);
    level.target.neighbourhoods = all_distances(target_, level.target, context_);
    level.landmarks = choose_landmarks(level.source.sampling.bases);
    return level;
  }

  SampledLevel finer_level(const SampledLevel& coarser) const {
    SampledLevel level{
        finer_shape_level(source_, source_orders_, coarser.source, options_.radii, context_),
        finer_shape_level(target_, target_orders_, coarser.target, options_.radii, context_),
        coarser.landmarks};
    if (static_cast<int>(coarser.landmarks.size()) < options_.list_size)
      level.landmarks = choose_landmarks(coarser.source.sampling.bases);
    return level;
  }

  /// Once there are enough they stay, so that their distance fields serve all further levels.
  std::vector<int> choose_landmarks(const std::vector<int>& bases) const {
    return farthest_points(source_.graph(), bases, options_.list_size, 0, context_);
  }

  std::vector<Correspondence> coarsest_matchings(const SampledLevel& level) {
    const StageTimer timer(times_, "patch matching");
    return match_whole_surfaces({level.source, source_}, {level.target, target_},
                                options_.coarse_candidates, options_.patches);
  }

  std::vector<PatchMatching> matched_patches(const SampledLevel& coarser, const SampledLevel& level,
                                             const MatchedLevel& previous) {
    const StageTimer timer(times_, "patch matching");
    const MatchDistortion distortion = landmark_distortion(
        level, previous.merge.merged.target_of_source, source_fields_, target_fields_, context_);
    return match_patch_pairs(coarser, previous, {level.source, source_}, {level.target, target_},
                             distortion, options_.patches, context_);
  }

  /// Section 4.2.
  MatchedLevel merged(const SampledLevel& level, std::vector<PatchMatching> patches,
                      const std::vector<int>& inherited) {
    const StageTimer timer(times_, "merging");
    MergeResult merge = merge_matches(level, union_of(patches), inherited, source_fields_,
                                      target_fields_, options_.merging, context_);
    return {std::move(patches), std::move(merge)};
  }

  const MetricSurface& source_;
  const MetricSurface& target_;
  const PaperOptions& options_;
  const Context& context_;
  std::vector<StageTime>& times_;
  SamplingOrders source_orders_, target_orders_;
  FieldStore source_fields_, target_fields_;
  std::vector<SampledLevel> sampled_;
};

/// Where the bases of the last level are matched, in the numbers of the meshes.
Correspondence matches_of(const Hypothesis& hypothesis, const SampledLevel& level,
                          const Surface& source, const Surface& target) {
  const std::vector<int>& image = hypothesis.levels.back().merge.merged.target_of_source;
  Correspondence between;
  for (std::size_t s = 0; s < image.size(); ++s)
    between.push_back({level.source.sampling.bases[s], level.target.sampling.bases[image[s]]});
  return to_input(source, target, SurfaceMatches(std::move(between)));
}

/// Keeps the least distorted hypothesis for which `is_right`, or, if it is so of none, the least
/// distorted one.
template <class IsRight>
void keep_least_distorted(std::vector<Hypothesis>& hypotheses, const IsRight& is_right) {
  std::ranges::stable_sort(hypotheses, {}, &Hypothesis::distortion);
  const auto right = std::ranges::find_if(hypotheses, is_right);
  if (right != hypotheses.end()) std::swap(hypotheses.front(), *right);
  hypotheses.resize(1);
}

struct BothSurfaces {
  MetricSurface source, target;
};

BothSurfaces metric_surfaces(const Shape& source, const Shape& target, const Context& context,
                             std::vector<StageTime>& times) {
  context.report(0, "geodesic graph");
  const StageTimer timer(times, "geodesic graph");
  return {source.prepared().metric(context), target.prepared().metric(context)};
}

PaperLevel result_of(const SampledLevel& sampled, MatchedLevel matched, double source_unit,
                     double target_unit) {
  PaperLevel level;
  level.source_radius = source_unit * sampled.source.sampling.radius;
  level.target_radius = target_unit * sampled.target.sampling.radius;
  level.source_bases = sampled.source.num_bases();
  level.target_bases = sampled.target.num_bases();
  level.matches = matched.merge.merged.matches();
  level.many_to_one = std::move(matched.merge.many_to_one);
  level.many_to_one_distortion = std::move(matched.merge.many_to_one_distortion);
  level.distortion = std::move(matched.merge.distortion);
  level.outliers_moved = matched.merge.outliers_moved;
  return level;
}

PaperResult result_of(const MetricSurface& source, const MetricSurface& target,
                      const std::vector<SampledLevel>& sampled, Hypothesis hypothesis) {
  const Surface& from = source.surface();
  const Surface& onto = target.surface();
  const std::vector<int>& sources = sampled.back().source.sampling.bases;
  PaperResult result;
  result.source_bases = to_input(from, SurfaceVertices(sources));
  result.target_bases = to_input(onto, SurfaceVertices(sampled.back().target.sampling.bases));
  VertexMap image_of(source.num_vertices(), kUnmatched);
  const std::vector<int>& image = hypothesis.levels.back().merge.merged.target_of_source;
  for (std::size_t s = 0; s < image.size(); ++s)
    image_of[sources[s]] = result.target_bases[image[s]];
  result.source_to_target = at_input(from, image_of, kUnmatched);
  for (std::size_t k = 0; k < sampled.size(); ++k)
    result.levels.push_back(
        result_of(sampled[k], std::move(hypothesis.levels[k]), from.scale, onto.scale));
  return result;
}

}  // namespace

void RadiusOptions::validate() const {
  if (!(radius_factor > 0)) throw InvalidInput("radius_factor must be positive");
  if (max_coarse_bases < 1 || max_coarse_bases > 12)
    throw InvalidInput("max_coarse_bases must be in [1, 12]");
  if (!(max_radius_ratio > 0 && max_radius_ratio < 1))
    throw InvalidInput("max_radius_ratio must be between 0 and 1");
  if (!(full_share > 0 && full_share <= 1)) throw InvalidInput("full_share must be in (0, 1]");
}

void PaperOptions::validate() const {
  saliency.validate();
  radii.validate();
  patches.validate();
  merging.validate();
  if (list_size < 1) throw InvalidInput("list_size must be at least 1");
  if (coarse_candidates < 1) throw InvalidInput("coarse_candidates must be at least 1");
  if (candidate_levels < 1) throw InvalidInput("candidate_levels must be at least 1");
  if (max_levels < 0) throw InvalidInput("max_levels must not be negative");
}

JointSampling sample_jointly(const Shape& source, const Shape& target, int level,
                             const PaperOptions& options, const Context& context) {
  options.validate();
  if (level < 0) throw InvalidInput("a level must not be negative");
  std::vector<StageTime> times;
  const MetricSurface from = source.prepared().metric(context);
  const MetricSurface onto = target.prepared().metric(context);
  Descent descent(from, onto, options, context, times);
  descent.sample_level();
  for (int k = 1; k <= level && !descent.complete(); ++k) descent.sample_level();
  const SampledLevel& last = descent.sampled().back();
  return {to_input(from.surface(), SurfaceVertices(last.source.sampling.bases)),
          to_input(onto.surface(), SurfaceVertices(last.target.sampling.bases))};
}

PaperResult match_paper(const Shape& source, const Shape& target, const PaperOptions& options,
                        const Context& context) {
  options.validate();
  std::vector<StageTime> times;
  const auto [from, onto] = metric_surfaces(source, target, context, times);
  Descent descent(from, onto, options, context, times);
  descent.sample_level();
  std::vector<Hypothesis> hypotheses = descent.match_coarsest();
  const auto keeps_orientation = [&](const Hypothesis& hypothesis) {
    // As many landmarks vote as decided all of the right and flipped maps tried.
    constexpr OrientationOptions kFewLandmarks{.landmarks = 100};
    return map_orientation(
               source, target,
               matches_of(hypothesis, descent.sampled().back(), from.surface(), onto.surface()),
               kFewLandmarks, context)
               .verdict == OrientationVerdict::kPreserves;
  };
  const auto choose = [&] {
    keep_least_distorted(hypotheses, [&](const Hypothesis& hypothesis) {
      return !options.keep_orientation || keeps_orientation(hypothesis);
    });
  };
  for (int k = 1; k <= options.max_levels && !descent.complete(); ++k) {
    context.report(descent.progress(), "matching");
    descent.sample_level();
    for (Hypothesis& hypothesis : hypotheses) descent.match_level(hypothesis);
    if (k == options.candidate_levels) choose();
  }
  if (hypotheses.size() > 1) choose();
  PaperResult result = result_of(from, onto, descent.sampled(), std::move(hypotheses.front()));
  result.complete = descent.complete();
  result.times = std::move(times);
  return result;
}

}  // namespace isomatch
