// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/finals.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "parallel.h"
#include "steps.h"
#include "tracked/tracks/reversal.h"

namespace isomatch::tracked {
namespace {

/// Least cost first, the same map once.
std::vector<Track> ranked(std::vector<Track> tracks, const Options& options) {
  if (options.elastic_judging) std::ranges::stable_sort(tracks, {}, &Track::cost);
  std::vector<Track> different;
  for (Track& track : tracks) {
    const bool known = std::ranges::any_of(different, [&](const Track& other) {
      return other.judged.source == track.judged.source &&
             difference(track, other) < options.hypotheses.same_difference;
    });
    if (!known) different.push_back(std::move(track));
  }
  return different;
}

constexpr const char* kRefinementStage = "refinement";

/// `step` of each, in parallel.
template <class Start, class Step>
std::vector<Track> all_tracks(const std::vector<Start>& starts, const Context& context,
                              const Step& step) {
  const auto count = static_cast<int>(starts.size());
  Steps steps(context, kRefinementStage, 0, 1, count);
  std::vector<std::optional<Track>> made(count);
  parallel_for(count, context, [&](std::ptrdiff_t i) {
    made[i].emplace(step(starts[i]));
    steps.take();
  });
  std::vector<Track> tracks;
  for (auto& track : made) tracks.push_back(std::move(*track));
  return tracks;
}

bool same_origin(const Judged& a, const Judged& b) {
  return a.source == b.source && a.hypothesis.target_nodes == b.hypothesis.target_nodes &&
         a.hypothesis.pose.has_value() == b.hypothesis.pose.has_value();
}

/// The first hypotheses, and motions of little energy, of parts all of little energy: distances
/// along surfaces, by which the order is made as well, mean nothing where these are full of holes.
std::vector<Judged> entrants_of(const std::vector<Judged>& judged, const Options& options) {
  if (options.different_maps > 1) return judged;
  const auto count = std::min(judged.size(), static_cast<std::size_t>(options.entrants));
  std::vector<Judged> entrants(judged.begin(), judged.begin() + static_cast<std::ptrdiff_t>(count));
  const double limit =
      options.hypotheses.poses.max_energy * std::ranges::min(entrants, {}, &Judged::energy).energy;
  std::vector<Judged> others(judged.begin() + static_cast<std::ptrdiff_t>(count), judged.end());
  std::erase_if(others, [&](const Judged& j) { return !j.hypothesis.pose || j.energy > limit; });
  std::ranges::stable_sort(others, {}, &Judged::energy);
  const auto followed =
      std::min(others.size(), static_cast<std::size_t>(options.hypotheses.poses.followed));
  entrants.insert(entrants.end(), others.begin(),
                  others.begin() + static_cast<std::ptrdiff_t>(followed));
  return entrants;
}

/// Those that fit best and, since a map may be torn for a while, the one that fitted best before;
/// none that costs too many times as much as the best, unless so many different maps are wanted.
std::vector<const Track*> finalists_of(const std::vector<Track>& tracks, const Judged& first,
                                       int most, double tolerance, int wanted) {
  std::vector<const Track*> finalists;
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    const bool good = std::cmp_less(k, most) || same_origin(tracks[k].judged, first);
    if ((good && tracks[k].cost() <= tolerance * tracks.front().cost()) || std::cmp_less(k, wanted))
      finalists.push_back(&tracks[k]);
  }
  return finalists;
}

/// How nearly as well as the winner the best other map fits.
double ambiguity(const Track& winner, const std::vector<Track>& tracks) {
  constexpr double kPerfect = 1e-5;  // Costs below this differ by the meshing alone.
  double own = std::numeric_limits<double>::infinity(), rival = own;
  for (const Track& track : tracks) {
    double& least = same_origin(track.judged, winner.judged) ? own : rival;
    least = std::min(least, kPerfect + track.cost());
  }
  return std::clamp(own / rival, 0.0, 1.0);
}

}  // namespace

Finals run_finals(const Pyramid& target, const std::vector<Judged>& judged, const Options& options,
                  const Context& context) {
  // Where of the whole the tracks are registered, through the middle and through the fine level.
  constexpr double kBegun = 0.2, kMiddle = 0.4, kFine = 0.8;
  const Refinement refinement(target, options, context);
  const auto step_of_all = [&](const auto& starts, double begin, double end, const auto& step) {
    context.check_stop();
    return ranked(all_tracks(starts, part_of(context, begin, end), step), options);
  };
  const auto best = [&](const std::vector<Track>& tracks, int most, double tolerance) {
    return finalists_of(tracks, judged.front(), most, tolerance, options.different_maps);
  };
  const std::vector<Track> begun =
      step_of_all(entrants_of(judged, options), 0, kBegun,
                  [&](const Judged& j) { return refinement.begin(j); });
  const std::vector<Track> middle =
      step_of_all(best(begun, options.followed, options.begun_tolerance), kBegun, kMiddle,
                  [&](const Track* track) { return refinement.follow(*track); });
  Finals finals;
  finals.middle_cost = middle.front().cost();
  finals.tracks = step_of_all(best(middle, options.finalists, options.middle_tolerance), kMiddle,
                              kFine, [&](const Track* track) { return refinement.finish(*track); });
  finals.ambiguity = ambiguity(finals.tracks.front(), finals.tracks.size() > 1 ? finals.tracks
                                                      : middle.size() > 1      ? middle
                                                                               : begun);
  if (std::cmp_greater(finals.tracks.size(), options.different_maps))
    finals.tracks.erase(finals.tracks.begin() + options.different_maps, finals.tracks.end());
  context.check_stop();
  if (options.rounds == 0) return finals;
  Steps steps(context, kRefinementStage, kFine, 1, static_cast<int>(finals.tracks.size()));
  for (Track& track : finals.tracks) {
    refinement.turn_an_end(track);
    settle_with_reverse(track, refinement, target, options, context);
    steps.take();
  }
  finals.nearest = refinement.nearest_nodes(finals.tracks.front());
  return finals;
}

SurfaceMatches contradicted_landmarks(const Pyramid& target,
                                      const std::vector<Judged>& contradicting, double middle_cost,
                                      Options options, const Context& context) {
  if (contradicting.empty()) return {};
  const Context silent{.threads = context.threads, .progress = {}, .stop = context.stop};
  const SurfaceMatches landmarks = std::exchange(options.landmarks, {});
  const Refinement refinement(target, options, silent);
  std::optional<Correspondence> fewest;
  std::vector<Judged> first = contradicting;
  first.resize(std::min(first.size(), static_cast<std::size_t>(options.followed)));
  const auto follow = [&](const Judged& judged) {
    return refinement.follow(refinement.begin(judged));
  };
  for (const Track& track : all_tracks(first, silent, follow)) {
    if (options.contradiction * track.cost() > middle_cost) continue;
    Correspondence contradicted;
    for (const Match& landmark : *landmarks)
      if (!satisfies(track.judged.hypothesis, landmark, *track.judged.source, target,
                     options.landmark_slack))
        contradicted.push_back(landmark);
    if (!fewest || contradicted.size() < fewest->size()) fewest = std::move(contradicted);
  }
  return SurfaceMatches(fewest.value_or(Correspondence()));
}

}  // namespace isomatch::tracked
