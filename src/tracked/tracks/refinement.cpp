// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/refinement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parallel.h"
#include "tracked/hypotheses/densify.h"
#include "tracked/tracks/deformed_surface.h"
#include "tracked/tracks/ends.h"
#include "tracked/tracks/mending.h"
#include "tracked/tracks/untorn.h"

namespace isomatch::tracked {
namespace {

/// Where the nodes nearest to landmarks belong: beside these, as the deformation turns them. Of
/// landmarks that share a node the first counts.
std::vector<elastic::Pin> landmark_pins(const Pyramid& source, const Pyramid& target,
                                        const elastic::Deformation& deformation,
                                        const SurfaceMatches& landmarks) {
  std::vector<elastic::Pin> pins;
  for (const Match& match : *landmarks) {
    const int node = nearest_node(source, match.source, deformation.size());
    if (std::ranges::count(pins, node, &elastic::Pin::point) > 0) continue;
    const Point beside =
        source.proxy.node_position(node) - source.surface->mesh.vertices[match.source];
    pins.push_back({node, target.surface->mesh.vertices[match.target] +
                              deformation.rotations()[node] * beside});
  }
  return pins;
}

/// Points outside stay where they are, or, at first, move with those around them.
void place_outside(const Track& track, std::vector<Point>& anchors) {
  if (!track.placed) return carry_outside(track.cloud, anchors);
  for (std::size_t i = 0; i < anchors.size(); ++i)
    if (!track.cloud.inside[i]) anchors[i] = track.deformation.positions()[i];
}

/// Which nodes of a level are inside, as those of the track are. Empty where nothing is missing.
std::vector<bool> inside_on(const Level& level, const Proxy& proxy, const Track& track) {
  std::vector<bool> inside;
  for (int i = 0; !track.cloud.inside.empty() && i < level.size(); ++i)
    inside.push_back(track.cloud.inside[track.source->graph.cell[proxy.nodes[i]]]);
  return inside;
}

/// The nodes of a track are at `positions`.
void place(Track& track, std::vector<Point> positions) {
  track.deformation.set_positions(std::move(positions));
  track.placed = true;
}

double price_of(const Judged& judged, const Options& options) {
  return (judged.source->view.mirrored ? options.mirror_price : 1) *
         (judged.hypothesis.pose ? options.hypotheses.poses.price : 1);
}

double between(double first, double last, double progress) {
  return first * std::pow(last / first, progress);
}

}  // namespace

Refinement::Refinement(const Pyramid& target, const Options& options, const Context& context)
    : target_(target),
      options_(options),
      context_(context),
      early_surface_(projection_onto(target.proxy, options.early_projection)),
      middle_surface_(projection_onto(target.proxy, options.middle_projection)),
      fine_surface_(projection_onto(target.proxy, options.fine_projection)),
      posed_surface_(projection_onto(target.proxy, options.posed_projection)) {}

Track Refinement::begin(const Judged& judged) const {
  Track track = registered(judged, judged.source->middle, target_.middle);
  weigh_left_out(track);
  return track;
}

Track Refinement::follow(Track track) const {
  const Level& middle = track.judged.source->middle;
  for (int round = 0; round < options_.middle_rounds(); ++round) {
    track.vertices = spectral_step(track, middle, round);
    run_round(track, round);
  }
  if (track.judged.hypothesis.pose || !options_.parts) weigh_left_out(track);
  if (track.judged.hypothesis.pose) return track;
  if (options_.middle_rounds() > 0) options_.parts ? extend(track) : mend(track);
  return track;
}

/// Moves nodes that are out of place, if the surfaces fit better for it.
void Refinement::mend(Track& track) const {
  std::vector<int> places;
  for (int vertex : track.vertices) places.push_back(track.target->graph.cell[vertex]);
  const std::vector<int> better =
      mended(track.judged.source->proxy, target_.proxy, track.cloud.areas, places,
             track.target->size(), options_.mending);
  if (better == places) return;
  Track other = track;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (better[i] != places[i]) other.vertices[i] = target_.proxy.nodes[better[i]];
  replace_if_better(track, std::move(other));
}

/// Nodes that were left out without a reason get the places that agree best with all others, if the
/// surfaces fit better for it.
void Refinement::extend(Track& track) const {
  weigh_left_out(track);
  Hypothesis known;
  const std::vector<int>& cell = track.target->graph.cell;
  for (int i = 0; i < track.source->size(); ++i) {
    if (!track.cloud.inside[i]) continue;
    known.source_nodes.push_back(i);
    known.target_nodes.push_back(cell[track.vertices[i]]);
  }
  if (known.source_nodes.empty()) return;
  const std::vector<int> places =
      densify(track.judged.source->proxy, target_.proxy, known, track.source->size());
  Track other = track;
  bool any = false;
  for (int i = 0; i < track.source->size(); ++i) {
    const int vertex = target_.proxy.nodes[places[i]];
    if (track.cloud.inside[i] || target_.proxy.to_boundary[vertex] < options_.partial.rim_width)
      continue;
    other.vertices[i] = vertex;
    other.cloud.inside[i] = any = true;
  }
  if (any) replace_if_better(track, std::move(other));
}

/// The other track, whose nodes have new places, if the surfaces fit better after a round.
void Refinement::replace_if_better(Track& track, Track other) const {
  advance(other, middle_surface_, options_.mending.registration);
  run_round(other, options_.middle_rounds() - 1);
  weigh_left_out(other);
  if (other.cost() < track.cost()) track = std::move(other);
}

Track Refinement::finish(const Track& middle) const {
  const Level& fine = middle.judged.source->fine;
  if (options_.rounds == 0) {
    Track track = registered(middle.judged, fine, target_.fine);
    weigh_left_out(track);
    return track;
  }
  const int first = options_.middle_rounds();
  Track track = middle;
  std::vector<int> vertices = spectral_step(track, fine, first);
  std::vector<Point> positions;
  if (track.judged.hypothesis.pose)
    positions = carried(track, fine);
  else if (!options_.parts)
    vertices = untorn(carried_vertices(track, fine), std::move(vertices), fine.graph.neighbours,
                      target_.proxy.mesh.vertices, options_);
  return fine_rounds(middle.judged, std::move(vertices),
                     inside_on(fine, middle.judged.source->proxy, track), first,
                     std::move(positions));
}

Track Refinement::fine_rounds(const Judged& judged, std::vector<int> vertices,
                              std::vector<bool> inside, int first,
                              std::vector<Point> positions) const {
  const Level& fine = judged.source->fine;
  Track track = enter(judged, fine, target_.fine, std::move(vertices), std::move(inside));
  if (!positions.empty()) place(track, std::move(positions));
  run_round(track, first);
  for (int round = first + 1; round < options_.rounds; ++round) {
    std::vector<int> places = spectral_step(track, fine, round);
    track.vertices = options_.parts
                         ? std::move(places)
                         : untorn(track.vertices, std::move(places), fine.graph.neighbours,
                                  target_.proxy.mesh.vertices, options_);
    run_round(track, round);
  }
  weigh_left_out(track);
  return track;
}

void Refinement::turn_an_end(Track& track) const {
  if (options_.parts || track.judged.hypothesis.pose) return;
  std::vector<int> vertices = with_an_end_turned(track, target_.proxy, fine_surface_, options_);
  if (vertices.empty()) return;
  const int last = options_.rounds - 1;
  Track turned = fine_rounds(track.judged, std::move(vertices), {}, last);
  // Every further round lessens the cost, so it is compared with what one makes of the other.
  const Track unturned = fine_rounds(track.judged, track.vertices, {}, last);
  const double energy = turned.registration.energy / unturned.registration.energy,
               cost = turned.cost() / unturned.cost(), most = options_.turning.max_remaining;
  if (energy < most && cost < most * energy) track = std::move(turned);
}

void Refinement::settle(Track& track, std::span<const Point> anchors) const {
  advance(track, surface_of(track), options_.settling, anchors);
}

Track Refinement::settled(const Judged& judged, std::vector<int> vertices, std::vector<bool> inside,
                          std::vector<Point> anchors) const {
  Track track =
      enter(judged, judged.source->fine, target_.fine, std::move(vertices), std::move(inside));
  if (!track.cloud.inside.empty()) carry_outside(track.cloud, anchors);
  set_places(track.cloud, target_.proxy, track.vertices);
  settle(track, anchors);
  return track;
}

/// The hypothesis after a first registration.
Track Refinement::registered(const Judged& judged, const Level& source, const Level& target) const {
  Track track = enter(
      judged, source, target,
      node_vertices(target_.proxy,
                    densify(judged.source->proxy, target_.proxy, judged.hypothesis, source.size())),
      covered_nodes(judged.hypothesis, *judged.source, target_, source.size(), options_));
  if (judged.hypothesis.pose) place(track, posed(*judged.hypothesis.pose, track.cloud.positions));
  advance(track, judged.hypothesis.pose ? posed_surface_ : early_surface_,
          options_.first_registration);
  return track;
}

Track Refinement::enter(const Judged& judged, const Level& source, const Level& target,
                        std::vector<int> vertices, std::vector<bool> inside) const {
  Track track{judged,
              &source,
              &target,
              source.graph.cloud,
              std::move(vertices),
              {source.graph.cloud.positions, source.graph.neighbours},
              {},
              price_of(judged, options_)};
  track.cloud.inside = std::move(inside);
  return track;
}

/// The map that a spectral step makes of a track, for the nodes of `wanted`.
std::vector<int> Refinement::spectral_step(Track& track, const Level& wanted, int round) const {
  context_.check_stop();
  if (track.judged.hypothesis.pose) {
    std::vector<int> vertices;
    for (int i = 0; i < wanted.size(); ++i)
      vertices.push_back(
          track.vertices[track.source->graph.cell[track.judged.source->proxy.nodes[i]]]);
    return vertices;
  }
  if (options_.parts) return overlap_step(track, wanted, round);
  return refine(track.source->samples, track.target->samples, target_.basis,
                {track.vertices, nearest_nodes(track)}, wanted.samples, basis_size(round),
                context_);
}

/// Nodes of a level as they move along with those of the track.
std::vector<Point> Refinement::carried(const Track& track, const Level& wanted) {
  const Proxy& proxy = track.judged.source->proxy;
  const DeformedSurface deformed = deformed_surface(proxy, track.deformation, track.cloud);
  return selected(deformed.positions, {proxy.nodes.begin(), proxy.nodes.begin() + wanted.size()});
}

/// Where those nodes are on the target.
std::vector<int> Refinement::carried_vertices(const Track& track, const Level& wanted) const {
  const Proxy& proxy = track.judged.source->proxy;
  const DeformedSurface deformed = deformed_surface(proxy, track.deformation, track.cloud);
  const elastic::Projection& surface = surface_of(track);
  std::vector<elastic::Foot> feet;
  for (int i = 0; i < wanted.size(); ++i) {
    const int v = proxy.nodes[i];
    feet.push_back(surface(deformed.positions[v], deformed.normals[v], deformed.features[v]));
  }
  return nearest_vertices(target_.proxy.mesh, feet);
}

/// The same on what overlaps. Nodes outside stay where those around them are.
std::vector<int> Refinement::overlap_step(Track& track, const Level& wanted, int round) const {
  const int first_fine = options_.middle_rounds() + 1,
            half_way = (options_.middle_rounds() + options_.rounds) / 2;
  const std::vector<int> nearest = nearest_nodes(track);
  if (!is_fine(track))
    track.overlap = overlap_of(track, nearest, basis_size(round));
  else if (!track.overlap || round == first_fine || round == half_way)
    track.overlap = overlap_of(track, nearest, options_.pyramid.functions);
  const Proxy& source = track.judged.source->proxy;
  std::vector<int> vertices(wanted.size(), kNoVertex);
  const Overlap& overlap = *track.overlap;
  if (!overlap.source.empty() && !overlap.target.empty()) {
    const int size = std::max(options_.first_basis,
                              static_cast<int>(std::lround(basis_size(round) * overlap.area)));
    vertices = refine_on_overlap(
        overlap, source, target_.proxy,
        {*track.source, *track.target, track.cloud.inside, track.vertices, nearest}, wanted, size,
        context_);
  }
  for (int i = 0; i < wanted.size(); ++i)
    if (vertices[i] == kNoVertex)
      vertices[i] = track.vertices[track.source->graph.cell[source.nodes[i]]];
  return vertices;
}

std::shared_ptr<const Overlap> Refinement::overlap_of(const Track& track,
                                                      const std::vector<int>& nearest,
                                                      int functions) const {
  auto overlap = std::make_shared<Overlap>();
  for (int i = 0; i < track.source->size(); ++i)
    if (track.cloud.inside[i]) overlap->area += track.cloud.areas[i];
  functions = std::max(options_.first_basis,
                       static_cast<int>(std::lround(functions * std::min(1.0, overlap->area))));
  overlap->source = part_of_proxy(track.judged.source->proxy, *track.source, track.cloud.inside,
                                  functions, context_);
  overlap->target = part_of_proxy(target_.proxy, *track.target, covered_target(track, nearest),
                                  functions, context_);
  return overlap;
}

/// How far a node covers what is around it.
double Refinement::covering_reach(const Track& track) const {
  return options_.partial.cover * std::sqrt(track.judged.source->area() / track.source->size());
}

std::vector<bool> Refinement::covered_target(const Track& track,
                                             const std::vector<int>& nearest) const {
  if (!options_.parts) return {};
  const elastic::PointCloud& target = track.target->graph.cloud;
  const double reach = covering_reach(track);
  std::vector<bool> covered(nearest.size());
  for (std::size_t i = 0; i < nearest.size(); ++i)
    covered[i] = track.cloud.inside[nearest[i]] &&
                 (target.positions[i] - track.deformation.positions()[nearest[i]]).norm() <= reach;
  return smoothed(covered, target.areas, track.target->graph.neighbours, options_.partial);
}

const elastic::Projection& Refinement::surface_of(const Track& track) const {
  if (track.judged.hypothesis.pose) return posed_surface_;
  return is_fine(track) ? fine_surface_ : middle_surface_;
}

bool Refinement::is_fine(const Track& track) { return track.source == &track.judged.source->fine; }

std::vector<int> Refinement::nearest_nodes(const Track& track) const {
  const elastic::Deformation& deformation = track.deformation;
  std::vector<Point> normals;
  for (int i = 0; i < deformation.size(); ++i)
    normals.push_back(deformation.rotations()[i] * track.cloud.normals[i]);
  const elastic::NearestPoint nearest_source(deformation.positions(), normals, track.cloud.features,
                                             track.judged.hypothesis.pose
                                                 ? options_.posed_projection
                                             : is_fine(track) ? options_.fine_projection
                                                              : options_.middle_projection);
  const elastic::PointCloud& target = track.target->graph.cloud;
  std::vector<int> nearest(track.target->size());
  parallel_for(std::ssize(nearest), context_, [&](std::ptrdiff_t i) {
    nearest[i] = nearest_source(target.positions[i], target.normals[i], target.features[i]);
  });
  return nearest;
}

void Refinement::run_round(Track& track, int round) const {
  elastic::RegistrationOptions step = options_.alternation;
  step.first_length = step.last_length =
      between(step.first_length, step.last_length, progress(round));
  advance(track, surface_of(track), step);
}

void Refinement::advance(Track& track, const elastic::Projection& onto,
                         const elastic::RegistrationOptions& step) const {
  set_places(track.cloud, target_.proxy, track.vertices);
  std::vector<Point> anchors = selected(target_.proxy.mesh.vertices, track.vertices);
  if (track.placed && track.judged.hypothesis.pose)
    anchors = track.deformation.positions();
  else if (options_.parts)
    place_outside(track, anchors);
  advance(track, onto, step, anchors);
}

void Refinement::advance(Track& track, const elastic::Projection& onto,
                         const elastic::RegistrationOptions& step,
                         std::span<const Point> anchors) const {
  context_.check_stop();
  track.registration = register_onto(
      track.cloud, track.deformation, onto, anchors, step,
      landmark_pins(*track.judged.source, target_, track.deformation, options_.landmarks),
      context_);
  track.placed = true;
  if (options_.parts) look_at_overlap(track);
  track.vertices = nearest_vertices(target_.proxy.mesh, track.registration.feet);
  set_places(track.cloud, target_.proxy, track.vertices);
}

void Refinement::look_at_overlap(Track& track) const {
  track.cloud.inside =
      inside_after(track.cloud, track.deformation.neighbours(), track.registration, options_);
}

/// How far what the source does not cover is from it, integrated over the target: a limb that the
/// source has folded away costs nothing else.
double Refinement::distance_uncovered(const Track& track) const {
  const elastic::PointCloud& target = track.target->graph.cloud;
  const std::vector<int> nearest = nearest_nodes(track);
  const double reach = covering_reach(track);
  double sum = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const double distance =
        (target.positions[i] - track.deformation.positions()[nearest[i]]).norm();
    sum += target.areas[i] * std::max(0.0, distance - reach);
  }
  return sum;
}

/// Prices what is left out of both shapes.
void Refinement::weigh_left_out(Track& track) const {
  if (!options_.parts) {
    track.distance_left_out = distance_uncovered(track);
    return;
  }
  const PartialOptions& partial = options_.partial;
  const Proxy& source = track.judged.source->proxy;
  const std::vector<int> nearest = nearest_nodes(track);
  const std::vector<bool> covered = covered_target(track, nearest);
  std::vector<bool> by_rim;
  for (const int node : nearest)
    by_rim.push_back(source.to_boundary[source.nodes[node]] < partial.rim_width);
  const NodeGraph& target = track.target->graph;
  const double area =
      left_out({track.cloud.inside, feet_by_rim(track.registration, target_.proxy, partial),
                track.cloud.areas, track.deformation.neighbours()},
               partial) +
      left_out({covered, by_rim, target.cloud.areas, target.neighbours}, partial) -
      std::abs(track.judged.source->area() - target_.area());
  track.energy_left_out = partial.energy_price * std::max(0.0, area);
  track.distance_left_out = partial.distance_price * std::max(0.0, area);
}

double Refinement::progress(int round) const {
  return static_cast<double>(round) / std::max(1, options_.rounds - 1);
}

int Refinement::basis_size(int round) const {
  return static_cast<int>(
      std::lround(between(options_.first_basis, options_.pyramid.functions, progress(round))));
}

double difference(const Track& a, const Track& b) {
  constexpr double kLeftOut = 0.2;  // As far apart as if a limb went elsewhere.
  double sum = 0;
  for (int i = 0; i < a.source->size(); ++i) {
    if (!a.cloud.is_inside(i) && !b.cloud.is_inside(i)) continue;
    const bool both = a.cloud.is_inside(i) && b.cloud.is_inside(i);
    sum += a.cloud.areas[i] *
           (both ? (a.registration.feet[i].position - b.registration.feet[i].position).squaredNorm()
                 : kLeftOut * kLeftOut);
  }
  return std::sqrt(sum);
}

}  // namespace isomatch::tracked
