// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/tracked.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>

#include "geometry/interpolation.h"
#include "isomatch/error.h"
#include "parallel.h"
#include "shape/boundary.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"
#include "steps.h"
#include "tracked/match.h"
#include "tracked/separation.h"
#include "tracked/tracks/dense_map.h"
#include "tracked/tracks/finals.h"
#include "tracked/tracks/followers.h"

namespace isomatch {
namespace {

using namespace tracked;

/// Landmarks between the surfaces. Throws `InvalidInput` if one is out of range or not part of a
/// surface, or a source vertex has two.
SurfaceMatches checked_landmarks(const Surface& source, const Surface& target,
                                 const Correspondence& landmarks) {
  std::vector<int> sources, targets;
  for (const auto& [s, t] : landmarks) {
    sources.push_back(s);
    targets.push_back(t);
  }
  on_surface(source, sources, "source vertex");
  on_surface(target, targets, "target vertex");
  std::ranges::sort(sources);
  const auto twice = std::ranges::adjacent_find(sources);
  if (twice != sources.end())
    throw InvalidInput(fmt::format("source vertex {} has two landmarks", *twice));
  SurfaceMatches result = on_surfaces(source, target, landmarks);
  const auto differ = std::ranges::adjacent_find(*result, {}, &Match::source);
  if (differ != result->end())
    throw InvalidInput(fmt::format("copies of source vertex {} on a seam have different landmarks",
                                   source.input_vertex[differ->source]));
  return result;
}

/// Of the caller's `landmarks` those that are among `contradicted`.
Correspondence those_between(const Surface& source, const Surface& target,
                             const Correspondence& landmarks, const SurfaceMatches& contradicted) {
  Correspondence found;
  for (const Match& landmark : landmarks) {
    const Match between{surface_vertex(source, landmark.source),
                        surface_vertex(target, landmark.target)};
    if (std::ranges::count(*contradicted, between) > 0) found.push_back(landmark);
  }
  return found;
}

/// Where of the whole stages begin, as measured on shapes of 5,000 to 42,000 vertices.
constexpr double kHypothesesBegin = 0.28, kRefinementBegin = 0.6, kDenseMapBegin = 0.97;

/// How a pair looks at its shapes.
struct Views {
  View source, target;
  std::string scale;

  bool parts() const { return source.open || target.open; }
};

/// Whether something may be missing: not of a mesh so small that most of it is boundary.
bool is_open(const Surface& surface, const PartialOptions& options) {
  return boundary_length(surface.mesh) > options.open_boundary &&
         std::ssize(boundary_vertices(surface.mesh)) < surface.num_vertices() / 2;
}

/// Whether both shapes end at the same places, as far as sizes tell: patches, not parts.
bool end_alike(const Surface& source, const Surface& target, const PartialOptions& options) {
  const auto alike = [](double a, double b, double times) {
    return std::max(a, b) <= times * std::min(a, b);
  };
  return alike(source.scale, target.scale, options.same_size) &&
         alike(source.scale * boundary_length(source.mesh),
               target.scale * boundary_length(target.mesh), options.same_boundary);
}

/// "same" or "area".
std::string chosen_scale(const Surface& source, const Surface& target, bool parts,
                         const std::string& wanted) {
  constexpr double kSameUnits = 4;  // What is more times as large is in other units.
  if (wanted != "auto") return wanted;
  const auto [less, more] = std::minmax(source.scale, target.scale);
  return parts && more <= kSameUnits * less ? "same" : "area";
}

Views views_of(const Surface& source, const Surface& target, const TrackedOptions& wanted,
               const PartialOptions& options) {
  Views views;
  views.source.open = !wanted.whole && is_open(source, options);
  views.target.open = !wanted.whole && is_open(target, options);
  if (views.source.open && views.target.open && end_alike(source, target, options))
    views.source.open = views.target.open = false;
  views.scale = chosen_scale(source, target, views.parts(), wanted.scale);
  if (views.scale == "area") return views;
  const double unit = std::max(source.scale, target.scale);
  views.source.size = source.scale / unit;
  views.target.size = target.scale / unit;
  return views;
}

PairView taken_for(const Views& views, const Surface& source, const Surface& target) {
  return {views.source.open, views.target.open, views.scale, source.scale / views.source.size,
          target.scale / views.target.size};
}

Options for_parts(Options options) {
  options.parts = true;
  options.entrants = options.partial.entrants;
  options.followed = options.entrants + options.hypotheses.poses.followed;
  options.first_registration.iterations = options.partial.first_iterations;
  if (options.rounds > 0) options.rounds = options.partial.rounds;
  options.begun_tolerance = options.middle_tolerance = std::numeric_limits<double>::infinity();
  options.hypotheses.poses.price = options.partial.pose_price;
  options.hypotheses.poses.improved = options.partial.improved_poses;
  options.hypotheses.growth.price = options.partial.landmark_price;
  options.hypotheses.growth.doubt = options.partial.doubt;
  return options;
}

/// The target, the source, and the source's mirror image if that may match as well.
Pyramids make_pyramids(const Shape& source, const Shape& target, const Views& views,
                       bool with_mirror, const PyramidOptions& options, const Context& context) {
  struct Request {
    const Shape* shape;
    View view;
  };
  std::vector<Request> requests{{&target, views.target}, {&source, views.source}};
  if (with_mirror) {
    requests.push_back({&source, views.source});
    requests.back().view.mirrored = true;
  }
  Steps steps(context, "shapes", 0, 1, kPyramidSteps * static_cast<int>(requests.size()));
  const Context alone{.threads = 1,
                      .progress = [&](double, std::string_view) { steps.take(); },
                      .stop = context.stop};
  Pyramids pyramids(requests.size());
  parallel_for(std::ssize(requests), context, [&](std::ptrdiff_t k) {
    pyramids[k] = pyramid_of(requests[k].shape->prepared(), requests[k].view, options, alone);
  });
  return pyramids;
}

/// Cuts the surfaces where the best track tears them, and begins again, if that fits better.
void cut_and_follow_again(const Separation& separation, Pyramids& pyramids, Candidates& candidates,
                          Finals& finals, const Options& options, const Context& context) {
  Pyramids cut = separation.cut_where_torn(pyramids, finals.tracks.front(), finals.nearest);
  if (cut == pyramids) return;
  // Of the time, how much judging takes.
  constexpr double kJudged = 0.4;
  Candidates again = all_judged(cut, options, part_of(context, 0, kJudged));
  if (again.possible.empty()) return;
  Finals followed = run_finals(*cut.front(), again.possible, options, part_of(context, kJudged, 1));
  if (followed.tracks.front().cost() >= finals.tracks.front().cost()) return;
  pyramids = std::move(cut);
  candidates = std::move(again);
  finals = std::move(followed);
}

/// In the caller's numbers and coordinates.
TrackedMap tracked_map(const Shape& source, const Shape& target, const Track& track, DenseMap dense,
                       double unit, double reach) {
  const Surface& from = *source.prepared().surface();
  const Surface& onto = *target.prepared().surface();
  // A mirror image has its faces turned the other way.
  const Surface& tracked = *track.judged.source->surface;
  const auto at_target = [&](std::vector<Point> positions) {
    for (Point& p : positions) p = p * unit + onto.centre;
    return at_input(source.mesh(), from, positions);
  };
  SurfaceMap source_to_target = to_input(from, onto, dense.source_to_target);
  match_followers(source.mesh(), from, onto, at_target(std::move(dense.registered)), reach * unit,
                  source_to_target);
  return {.source_to_target = std::move(source_to_target),
          .target_to_source = to_input(onto, tracked, dense.target_to_source),
          .source_confidence = at_input(from, dense.source_confidence, 0.0F),
          .target_confidence = at_input(onto, dense.target_confidence, 0.0F),
          .registered = at_target(std::move(dense.unfolded)),
          .energy = track.registration.energy + track.energy_left_out,
          .distance = track.registration.distance + track.distance_left_out,
          .deviation = track.registration.deviation,
          .distortion = track.judged.hypothesis.distortion,
          .orientation = track.judged.hypothesis.orientation,
          .mirrored = track.judged.source->view.mirrored};
}

std::vector<TrackedMap> dense_maps(const Shape& source, const Shape& target,
                                   const std::vector<Track>& tracks, const Pyramid& pyramid,
                                   const Options& options, const Context& context) {
  Steps steps(context, "dense map", 0, 1, static_cast<int>(tracks.size()));
  std::vector<TrackedMap> maps;
  for (const Track& track : tracks) {
    maps.push_back(tracked_map(source, target, track, dense_map(track, pyramid, options, context),
                               pyramid.surface->scale, options.partial.reach));
    steps.take();
  }
  return maps;
}

/// A track whose nodes are where `places` has the vertices of the source's surface.
Track settled_track(const Pyramid& source, const Pyramid& target, const SurfaceMap& places,
                    const Options& options, const Context& context) {
  const elastic::Projection nearest = projection_onto(target.proxy, {});
  std::vector<Point> anchors;
  std::vector<int> vertices;
  std::vector<bool> inside;
  for (int i = 0; i < source.fine.size(); ++i) {
    const int detail = source.proxy.detail_vertex[source.proxy.nodes[i]];
    const SurfacePoint& place = places[source.detail.surface_vertex[detail]];
    inside.push_back(place.face != kNoFace);
    anchors.push_back(source.proxy.node_position(i));
    vertices.push_back(target.proxy.nodes.front());
    if (!inside.back()) continue;
    const Surface& surface = *target.surface;
    anchors.back() = position(surface.mesh, place);
    const Point normal = interpolated(surface.mesh, surface.normals, place).stableNormalized();
    vertices.back() = heaviest_corner(target.proxy.mesh, nearest(anchors.back(), normal, {}).point);
  }
  if (!options.parts) inside.clear();
  Judged judged;
  judged.source = &source;
  return Refinement(target, options, context)
      .settled(judged, std::move(vertices), std::move(inside), std::move(anchors));
}

void check_found(const Candidates& candidates) {
  if (!candidates.possible.empty()) return;
  throw InvalidInput(candidates.contradicting.empty()
                         ? "the shapes have too little in common: there is no hypothesis to follow"
                         : "there is no map that satisfies the landmarks");
}

void check_overlap(const Track& track) {
  const std::vector<bool>& inside = track.cloud.inside;
  if (!inside.empty() && std::ranges::count(inside, true) == 0)
    throw InvalidInput("the shapes have too little in common: nothing of them overlaps");
}

}  // namespace

Options tracked::options_of(const TrackedOptions& options) {
  Options result;
  result.elastic_judging = options.elastic_judging;
  result.hypotheses.growth.orientation = options.orientation;
  result.different_maps = options.alternatives + 1;
  if (!options.elastic_judging) result.entrants = result.finalists = 1;
  if (!options.refinement) result.rounds = 0;
  return result;
}

void TrackedOptions::validate() const {
  if (alternatives < 0) throw InvalidInput("alternatives must not be negative");
  if (scale != "auto" && scale != "same" && scale != "area")
    throw InvalidInput(fmt::format("scale: expected auto, same or area, not {}", scale));
}

void check_landmarks(const Shape& source, const Shape& target, const Correspondence& landmarks) {
  checked_landmarks(*source.prepared().surface(), *target.prepared().surface(), landmarks);
}

TrackedResult match_tracked(const Shape& source, const Shape& target, const TrackedOptions& options,
                            const Context& context) {
  options.validate();
  return match(source, target, options, options_of(options), context);
}

TrackedResult tracked::match(const Shape& source, const Shape& target,
                             const TrackedOptions& tracked_options, Options options,
                             const Context& context) {
  options.validate();
  const Surface& from = *source.prepared().surface();
  const Surface& onto = *target.prepared().surface();
  options.landmarks = checked_landmarks(from, onto, tracked_options.landmarks);
  TrackedResult result;
  const Context silent{.threads = context.threads, .progress = {}, .stop = context.stop};
  const auto timed = [&](std::string_view stage, double begin, double end, const auto& work) {
    context.report(begin, stage);
    const StageTimer timer(result.times, stage);
    return work(part_of(context, begin, end));
  };
  const Views views = views_of(from, onto, tracked_options, options.partial);
  result.taken_for = taken_for(views, from, onto);
  if (views.parts()) options = for_parts(options);
  Pyramids pyramids = timed("shapes", 0, kHypothesesBegin, [&](const Context& part) {
    return make_pyramids(source, target, views, tracked_options.allow_reflection, options.pyramid,
                         part);
  });
  result.oriented = from.oriented && onto.oriented;
  const Separation separation(
      pyramids,
      [&](std::size_t k, const View& view) {
        return pyramid_of((k == 0 ? target : source).prepared(), view, options.pyramid, silent);
      },
      options, silent);
  Candidates candidates =
      timed("hypotheses", kHypothesesBegin, kRefinementBegin, [&](const Context& part) {
        // Of the time, how much the first of many takes.
        const double first = separation.is_possible() ? 0.2 : 1;
        Candidates judged = all_judged(pyramids, options, part_of(part, 0, first));
        separation.open_handles(pyramids, judged, part_of(part, first, 1));
        return judged;
      });
  check_found(candidates);
  for (const Judged& j : candidates.possible)
    result.hypotheses.push_back({j.hypothesis.distortion, j.hypothesis.orientation, j.energy});
  const Finals finals =
      timed("refinement", kRefinementBegin, kDenseMapBegin, [&](const Context& part) {
        const double first = separation.is_possible() ? 0.5 : 1;
        Finals followed =
            run_finals(*pyramids.front(), candidates.possible, options, part_of(part, 0, first));
        cut_and_follow_again(separation, pyramids, candidates, followed, options,
                             part_of(part, first, 1));
        result.contradicted_landmarks =
            those_between(from, onto, tracked_options.landmarks,
                          contradicted_landmarks(*pyramids.front(), candidates.contradicting,
                                                 followed.middle_cost, options, context));
        return followed;
      });
  check_overlap(finals.tracks.front());
  result.taken_for.source_is_cut = !finals.tracks.front().judged.source->view.cut.empty();
  result.taken_for.target_is_cut = !pyramids.front()->view.cut.empty();
  result.ambiguity = finals.ambiguity;
  result.maps = timed("dense map", kDenseMapBegin, 1, [&](const Context& part) {
    return dense_maps(source, target, finals.tracks, *pyramids.front(), options, part);
  });
  return result;
}

TrackedMap tracked::settled(const Shape& source, const Shape& target, const SurfaceMap& places,
                            const TrackedOptions& tracked_options, const Context& context) {
  Options options = options_of(tracked_options);
  const Views views = views_of(*source.prepared().surface(), *target.prepared().surface(),
                               tracked_options, options.partial);
  if (views.parts()) options = for_parts(options);
  const Context silent{.threads = context.threads, .progress = {}, .stop = context.stop};
  const Pyramids pyramids = make_pyramids(source, target, views, false, options.pyramid, silent);
  const Track track = settled_track(*pyramids[1], *pyramids.front(), places, options, silent);
  return tracked_map(source, target, track, dense_map(track, *pyramids.front(), options, silent),
                     pyramids.front()->surface->scale, options.partial.reach);
}

Correspondence matches(const Shape& source, const Shape& target, const TrackedMap& map) {
  const Surface& from = *source.prepared().surface();
  const Surface& onto = *target.prepared().surface();
  const VertexMap forward =
      nearest_vertices(onto.mesh, *on_surfaces(from, onto, map.source_to_target));
  const VertexMap backward =
      nearest_vertices(from.mesh, *on_surfaces(onto, from, map.target_to_source));
  Correspondence matches = to_correspondence(forward);
  std::vector<bool> hit(backward.size(), false);
  for (const Match& match : matches) hit[match.target] = true;
  for (std::size_t t = 0; t < backward.size(); ++t)
    if (!hit[t] && backward[t] != kUnmatched) matches.push_back({backward[t], static_cast<int>(t)});
  return to_input(from, onto, SurfaceMatches(std::move(matches)));
}

}  // namespace isomatch
