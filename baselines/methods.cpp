// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gmds/gmds.h"
#include "isomatch/error.h"
#include "isomatch/methods/paper.h"
#include "isomatch/methods/tracked.h"
#include "method.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"
#include "spectral/spectral.h"
#include "zoomout/zoomout.h"

namespace isomatch::baselines {
namespace {

/// What rivals work on.
struct Both {
  Both(const Shape& source_shape, const Shape& target_shape, const Context& context)
      : source(source_shape.prepared().metric(context)),
        target(target_shape.prepared().metric(context)) {}

  /// A map between the surfaces' vertices, in the numbers of the meshes.
  Correspondence to_input(const VertexMap& source_to_target) const {
    return isomatch::to_input(source.surface(), target.surface(),
                              SurfaceMatches(to_correspondence(source_to_target)));
  }

  MetricSurface source, target;
};

Correspondence nearest_matches(const Shape& target, const SurfaceMap& map) {
  return to_correspondence(nearest_vertices(target.mesh(), map));
}

/// Matches between bases as ones between vertices.
Correspondence between_vertices(const PaperResult& result, const Correspondence& matches) {
  Correspondence vertices;
  for (const auto& [s, t] : matches)
    vertices.push_back({result.source_bases[s], result.target_bases[t]});
  std::ranges::sort(vertices);
  return vertices;
}

LevelSummary summary(const PaperLevel& level) {
  return {level.source_bases, level.target_bases, summarize(level.many_to_one_distortion).mean,
          summarize(level.distortion).mean};
}

MethodResult run_paper(const Shape& source, const Shape& target, const PaperOptions& options,
                       const Context& context) {
  const PaperResult result = match_paper(source, target, options, context);
  MethodResult all;
  all.maps.push_back({kFinalMap, to_correspondence(result.source_to_target), {}});
  all.maps.push_back({kManyToMany, between_vertices(result, result.levels.back().matches), {}});
  for (std::size_t k = 0; k < result.levels.size(); ++k) {
    const PaperLevel& level = result.levels[k];
    all.maps.push_back({fmt::format("level{}_many_to_one", k),
                        between_vertices(result, to_correspondence(level.many_to_one)),
                        {}});
    all.levels.push_back(summary(level));
  }
  all.times = result.times;
  return all;
}

MethodResult run_paper_as_published(const Shape& source, const Shape& target,
                                    const Context& context) {
  return run_paper(source, target, {}, context);
}

MethodResult run_paper_oriented(const Shape& source, const Shape& target, const Context& context) {
  PaperOptions options;
  options.keep_orientation = true;
  return run_paper(source, target, options, context);
}

MethodResult run_tracked(const Shape& source, const Shape& target, const Context& context) {
  const TrackedResult result = match_tracked(source, target, {}, context);
  const TrackedMap& best = result.maps.front();
  return {{{kFinalMap, nearest_matches(target, best.source_to_target), best.source_to_target},
           {kManyToMany, matches(source, target, best), {}}},
          {},
          result.times};
}

/// At the level of the paper's Table 1, on the same base vertices.
MethodResult run_spectral(const Shape& source, const Shape& target, const Context& context) {
  constexpr int kLevel = 4;
  const JointSampling bases = sample_jointly(source, target, kLevel, {}, context);
  const Both both(source, target, context);
  const JointSampling on_surfaces{*on_surface(both.source.surface(), bases.source, "source base"),
                                  *on_surface(both.target.surface(), bases.target, "target base")};
  const SpectralResult result = match_spectral(both.source, both.target, on_surfaces, {}, context);
  Correspondence between_bases;
  for (std::size_t i = 0; i < bases.source.size(); ++i)
    between_bases.push_back({bases.source[i], bases.target[result.base_matches[i]]});
  std::ranges::sort(between_bases);
  return {{{kFinalMap, both.to_input(result.source_to_target), {}}, {"bases", between_bases, {}}},
          {},
          {}};
}

MethodResult run_gmds(const Shape& source, const Shape& target, const Context& context) {
  const Both both(source, target, context);
  GmdsResult result = match_gmds(both.source, both.target, {}, context);
  SurfaceMap points(both.source.num_vertices());
  for (std::size_t i = 0; i < result.points.size(); ++i)
    points[result.source_vertices[i]] = result.points[i];
  SurfaceMap map = to_input(both.source.surface(), both.target.surface(), SurfacePoints(points));
  return {{{kFinalMap, nearest_matches(target, map), std::move(map)}}, {}, std::move(result.times)};
}

MethodResult run_zoomout(const Shape& source, const Shape& target, const Context& context) {
  const Both both(source, target, context);
  const ZoomOutResult result = match_zoomout(both.source, both.target, {}, context);
  return {{{kFinalMap, both.to_input(result.source_to_target), {}}}, {}, result.times};
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> all{
      {"paper", "coarse-to-fine combinatorial matching (Sahillioglu and Yemez 2011)",
       run_paper_as_published},
      {"paper-oriented", "the same with a candidate that does not exchange left and right",
       run_paper_oriented},
      {"tracked", "the tracked method, default of isomatch", run_tracked},
      {"spectral", "geodesic affinities embedded and aligned (Jain and Zhang 2006)", run_spectral},
      {"gmds", "generalised multidimensional scaling (Bronstein et al. 2006)", run_gmds},
      {"zoomout",
       "functional maps with orientation and ZoomOut (Ren et al. 2018, Melzi et al. 2019)",
       run_zoomout},
  };
  return all;
}

const Method& find_method(const std::string& name) {
  const auto method = std::ranges::find(methods(), name, &Method::name);
  if (method != methods().end()) return *method;
  std::vector<std::string> names;
  for (const Method& known : methods()) names.push_back(known.name);
  throw InvalidInput(fmt::format("there is no method '{}': {}", name, fmt::join(names, ", ")));
}

}  // namespace isomatch::baselines
