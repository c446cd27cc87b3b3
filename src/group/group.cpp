// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/group/group.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "group/likeness.h"
#include "group/pairs.h"
#include "group/places.h"
#include "group/shape_pool.h"
#include "group/template_map.h"
#include "isomatch/error.h"
#include "parallel.h"
#include "shape/boundary.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"
#include "steps.h"
#include "tracked/match.h"
#include "tracked/options.h"

namespace isomatch {
namespace {

using namespace group;

/// Places settle within this many rounds: twice as many change errors by a thousandth.
constexpr int kRounds = 4;

class Group {
 public:
  Group(std::span<const Shape> shapes, const GroupOptions& options, const Context& context)
      : shapes_(shapes),
        options_(options),
        context_(context),
        surfaces_(surfaces_of(shapes)),
        pool_(shapes, options.memory),
        pairs_(pool_, surfaces_, options.matching) {}

  GroupResult run() {
    match_star();
    timed("neighbours", kNeighbours, kAgreement,
          [&](const Context& part) { pairs_.add(neighbours(), "neighbours", part); });
    timed("agreement", kAgreement, kMembers, [&](const Context& part) {
      find_places(part);
      if (pairs_.weed_out(places_, "agreement", part)) find_places(part);
    });
    GroupResult result;
    result.template_shape = template_;
    timed("members", kMembers, 1, [&](const Context& part) { result.members = all_members(part); });
    for (const MatchedPair& pair : pairs_.all())
      result.pairs.push_back({pair.source, pair.target, pair.cost(), pair.cycle_error, pair.use});
    result.times = std::move(times_);
    return result;
  }

 private:
  // Where of the whole stages begin.
  static constexpr double kNeighbours = 0.3, kAgreement = 0.85, kMembers = 0.9;

  template <class Work>
  void timed(std::string_view stage, double begin, double end, const Work& work) {
    context_.report(begin, stage);
    const StageTimer timer(times_, stage);
    work(part_of(context_, begin, end));
  }

  static std::vector<const Surface*> surfaces_of(std::span<const Shape> shapes) {
    std::vector<const Surface*> surfaces;
    for (const Shape& shape : shapes) surfaces.push_back(shape.prepared().surface().get());
    return surfaces;
  }

  int count() const { return static_cast<int>(shapes_.size()); }

  /// Whether something of a shape may be missing, as far as its boundary tells.
  bool is_part(int shape) const {
    return boundary_length(surfaces_[shape]->mesh) > tracked::PartialOptions().open_boundary;
  }

  /// None that lacks something, unless all do, and none that is far simpler than most: its vertices
  /// are those that are followed.
  std::vector<bool> eligible_templates() const {
    constexpr int kSimpler = 4;
    std::vector<int> sizes;
    for (const Surface* surface : surfaces_) sizes.push_back(surface->num_vertices());
    std::ranges::nth_element(sizes, sizes.begin() + count() / 2);
    const auto choose = [&](bool whole) {
      std::vector<bool> eligible(shapes_.size());
      for (int shape = 0; shape < count(); ++shape)
        eligible[shape] = kSimpler * surfaces_[shape]->num_vertices() >= sizes[count() / 2] &&
                          !(whole && is_part(shape));
      return eligible;
    };
    std::vector<bool> eligible = choose(true);
    return std::ranges::count(eligible, true) > 0 ? eligible : choose(false);
  }

  PairList star() const {
    PairList pairs;
    for (int shape = 0; shape < count(); ++shape)
      if (shape != template_) pairs.emplace_back(template_, shape);
    return pairs;
  }

  /// The star around the template; if none is given, one around the first shape tells how alike the
  /// shapes are, and so which is nearest to all.
  void match_star() {
    const auto add = [&](double begin, double end) {
      timed("star", begin, end, [&](const Context& part) { pairs_.add(star(), "star", part); });
    };
    template_ = options_.template_shape;
    if (template_ >= 0) return add(0, kNeighbours);
    std::vector<bool> eligible = eligible_templates();
    const auto first = static_cast<int>(std::ranges::find(eligible, true) - eligible.begin());
    template_ = first;
    add(0, kNeighbours / 2);
    template_ = likeness().most_central(eligible);
    // To a shape that is unlike all others all may seem near: where they lie on it says little.
    const bool in_doubt = template_ == first && std::ranges::count(eligible, true) > 1;
    eligible[first] = false;
    if (in_doubt) template_ = likeness().most_central(eligible);
    add(kNeighbours / 2, kNeighbours);
    if (in_doubt && !pairs_.fits_far_better(template_, first)) template_ = first;
  }

  PairList neighbours() const {
    // Of 30 people in 10 poses each, 8 had lower errors than 5, and as low as all.
    constexpr double kTimesLog = 1.5;
    const int wanted = options_.neighbours >= 0
                           ? options_.neighbours
                           : static_cast<int>(std::ceil(kTimesLog * std::log2(count())));
    const Likeness like = likeness();
    PairList pairs;
    for (int shape = 0; shape < count(); ++shape)
      for (const int other : like.nearest(shape, wanted)) pairs.emplace_back(shape, other);
    return pairs;
  }

  Likeness likeness() const {
    return {surfaces_, pairs_.graph().followed_from(template_), template_, context_};
  }

  void find_places(const Context& context) {
    const MapGraph maps = pairs_.graph();
    places_ = maps.followed_from(template_);
    maps.agree(places_, template_, kRounds, context);
  }

  GroupMember template_member() const {
    const Mesh& mesh = shapes_[template_].mesh();
    const SurfaceMap itself = at_surface(corner_points(mesh), template_);
    return {itself, itself, mesh.vertices, std::vector<float>(mesh.vertices.size(), 0.0F), {}};
  }

  bool is_placed(int shape) const {
    return std::ranges::any_of(places_[shape],
                               [](const SurfacePoint& place) { return place.face != kNoFace; });
  }

  GroupMember unmatched_member(int shape) const {
    return {SurfaceMap(shapes_[template_].mesh().vertices.size()),
            SurfaceMap(shapes_[shape].mesh().vertices.size()),
            {},
            std::vector<float>(shapes_[template_].mesh().vertices.size(), 0.0F),
            {FitGrade::kPoor, {"no map leads to it that agrees with others"}, {}}};
  }

  /// Without what is not part of the surface.
  SurfaceMap at_surface(SurfaceMap map, int shape) const {
    const Surface& surface = *surfaces_[shape];
    return to_input(surface, surface, on_surfaces(surface, surface, map));
  }

  SurfaceMap to_template(const GroupMember& member, int shape, const Context& context) const {
    const Surface& from = *surfaces_[template_];
    const Surface& onto = *surfaces_[shape];
    std::vector<Point> registered;
    for (const int v : from.input_vertex)
      registered.push_back((member.registered[v] - onto.centre) / onto.scale);
    return to_input(
        onto, from,
        SurfacePoints(map_to_template(from, onto, registered,
                                      *on_surfaces(from, onto, member.from_template), context)));
  }

  GroupMember member(const MapGraph& maps, int shape, const Context& context) {
    if (shape == template_) return template_member();
    if (!is_placed(shape)) return unmatched_member(shape);
    const Shape source = pool_.get(template_), target = pool_.get(shape);
    TrackedMap map = tracked::settled(source, target, places_[shape], options_.matching, context);
    FitOptions fit;
    fit.parts = !options_.matching.whole && (is_part(template_) || is_part(shape));
    fit.mirrored = pairs_.is_mirrored(template_, shape);
    GroupMember member;
    member.fit = judge_fit(source, target, map.source_to_target, fit, context);
    member.from_template = std::move(map.source_to_target);
    member.registered = std::move(map.registered);
    member.to_template = to_template(member, shape, context);
    member.spread = at_input(*surfaces_[template_], maps.spread(places_, shape), 0.0F);
    return member;
  }

  std::vector<GroupMember> all_members(const Context& context) {
    const MapGraph maps = pairs_.graph();
    const Context alone{.threads = 1, .progress = {}, .stop = context.stop};
    std::vector<GroupMember> members(shapes_.size());
    Steps steps(context, "members", 0, 1, count());
    parallel_for(count(), context, [&](std::ptrdiff_t k) {
      members[k] = member(maps, static_cast<int>(k), alone);
      steps.take();
    });
    return members;
  }

  std::span<const Shape> shapes_;
  const GroupOptions& options_;
  const Context& context_;
  std::vector<const Surface*> surfaces_;
  ShapePool pool_;
  Pairs pairs_;
  int template_ = 0;
  std::vector<Places> places_;
  std::vector<StageTime> times_;
};

}  // namespace

std::string_view to_string(PairUse use) {
  switch (use) {
    case PairUse::kAgrees:
      return "agrees";
    case PairUse::kRunnerUp:
      return "runner-up";
    case PairUse::kComposed:
      return "composed";
  }
  return "";
}

void GroupOptions::validate(int num_shapes) const {
  matching.validate();
  if (!matching.landmarks.empty()) throw InvalidInput("a group takes no landmarks");
  if (num_shapes < 2) throw InvalidInput("a group needs at least two shapes");
  if (template_shape >= num_shapes)
    throw InvalidInput(fmt::format("there is no shape {} for a template", template_shape));
}

GroupResult match_group(std::span<const Shape> shapes, const GroupOptions& options,
                        const Context& context) {
  options.validate(static_cast<int>(shapes.size()));
  return Group(shapes, options, context).run();
}

}  // namespace isomatch
