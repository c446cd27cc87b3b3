// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/judging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "parallel.h"
#include "steps.h"
#include "tracked/hypotheses/densify.h"
#include "tracked/tracks/overlap.h"

namespace isomatch::tracked {
namespace {

/// Of landmarks that share a node the first remains.
void drop_repeated_nodes(Correspondence& landmarks) {
  Correspondence kept;
  for (const Match& match : landmarks) {
    const bool repeated = std::ranges::any_of(kept, [&](const Match& other) {
      return other.source == match.source || other.target == match.target;
    });
    if (!repeated) kept.push_back(match);
  }
  landmarks = std::move(kept);
}

HypothesisOptions with_landmarks(const Pyramid& source, const Pyramid& target,
                                 const Options& options) {
  HypothesisOptions result = options.hypotheses;
  for (const Match& match : *options.landmarks)
    result.landmarks.push_back({nearest_node(source, match.source, source.proxy.num_measured()),
                                nearest_node(target, match.target, target.proxy.num_measured())});
  drop_repeated_nodes(result.landmarks);
  const auto most = static_cast<std::size_t>(result.coarse.source_landmarks / 2);
  result.landmarks.resize(std::min(result.landmarks.size(), most));
  result.growth.fixed = static_cast<int>(result.landmarks.size());
  return result;
}

/// Energy of a coarse, stiff registration that starts from a hypothesis, and the price of what is
/// left out.
double energy(const Pyramid& source, const Pyramid& target, const Hypothesis& hypothesis,
              const elastic::Projection& surface, const Options& options) {
  elastic::PointCloud cloud = source.coarse.graph.cloud;
  const std::vector<int> vertices =
      starting_vertices(hypothesis, source.proxy, target.proxy, surface, source.coarse.size());
  set_places(cloud, target.proxy, vertices);
  elastic::Deformation deformation(cloud.positions, source.coarse.graph.neighbours);
  std::vector<Point> anchors = hypothesis.pose ? posed(*hypothesis.pose, cloud.positions)
                                               : selected(target.proxy.mesh.vertices, vertices);
  cloud.inside = covered_nodes(hypothesis, source, target, source.coarse.size(), options);
  if (options.parts) carry_outside(cloud, anchors);
  const Context alone{
      .threads = 1, .progress = {}, .stop = {}};  // Many hypotheses are judged at a time.
  const elastic::Registration registration =
      register_onto(cloud, deformation, surface, anchors, options.judging, {}, alone);
  if (!options.parts) return registration.energy;
  const std::vector<bool> inside =
      inside_after(cloud, deformation.neighbours(), registration, options);
  const std::vector<bool> by_rim = feet_by_rim(registration, target.proxy, options.partial);
  return registration.energy +
         options.partial.energy_price *
             left_out({inside, by_rim, cloud.areas, deformation.neighbours()}, options.partial);
}

void reverse(Hypothesis& hypothesis) {
  std::swap(hypothesis.source_nodes, hypothesis.target_nodes);
  if (!hypothesis.pose) return;
  Pose& pose = *hypothesis.pose;
  pose.rotation.transposeInPlace();
  pose.shift = -(pose.rotation * pose.shift);
}

/// Hypotheses grow on the smaller shape, most of which has a counterpart.
std::vector<Hypothesis> hypotheses_between(const Pyramid& source, const Pyramid& target,
                                           const HypothesisOptions& options,
                                           const Context& context) {
  if (source.area() <= target.area())
    return find_hypotheses(source.proxy, target.proxy, options, context);
  HypothesisOptions reversed = options;
  for (Match& match : reversed.landmarks) std::swap(match.source, match.target);
  std::vector<Hypothesis> hypotheses =
      find_hypotheses(target.proxy, source.proxy, reversed, context);
  for (Hypothesis& hypothesis : hypotheses) reverse(hypothesis);
  return hypotheses;
}

std::vector<Judged> found_and_judged(const Pyramid& source, const Pyramid& target,
                                     const HypothesisOptions& search, const Options& options,
                                     const Context& context) {
  // Of the time, how much finding takes.
  constexpr double kFound = 0.7;
  std::vector<Hypothesis> hypotheses =
      hypotheses_between(source, target, search, part_of(context, 0, kFound));
  const elastic::Projection surface = projection_onto(target.proxy, options.early_projection),
                            posed_surface = projection_onto(target.proxy, options.posed_projection);
  Steps steps(context, "hypotheses", kFound, 1, static_cast<int>(hypotheses.size()));
  std::vector<Judged> judged(hypotheses.size());
  parallel_for(std::ssize(hypotheses), context, [&](std::ptrdiff_t k) {
    const double e = energy(source, target, hypotheses[k],
                            hypotheses[k].pose ? posed_surface : surface, options);
    judged[k] = {std::move(hypotheses[k]), e, &source};
    steps.take();
  });
  return judged;
}

}  // namespace

Candidates judged_hypotheses(const Pyramid& source, const Pyramid& target, const Options& options,
                             const Context& context) {
  const bool guided = !options.landmarks->empty();
  Candidates candidates;
  candidates.possible = found_and_judged(source, target, with_landmarks(source, target, options),
                                         options, part_of(context, 0, guided ? 0.5 : 1));
  if (guided) {
    // What few landmarks in unlucky places lead to must not hide the map that is found without.
    for (Judged& free :
         found_and_judged(source, target, options.hypotheses, options, part_of(context, 0.5, 1))) {
      const bool possible = std::ranges::all_of(*options.landmarks, [&](const Match& landmark) {
        return satisfies(free.hypothesis, landmark, source, target, options.landmark_slack);
      });
      (possible ? candidates.possible : candidates.contradicting).push_back(std::move(free));
    }
  }
  if (options.elastic_judging) {
    sort_by_cost(candidates.possible);
    sort_by_cost(candidates.contradicting);
  }
  return candidates;
}

bool satisfies(const Hypothesis& hypothesis, const Match& vertices, const Pyramid& source,
               const Pyramid& target, float slack) {
  const int from = nearest_node(source, vertices.source, source.proxy.num_measured());
  const int onto = nearest_node(target, vertices.target, target.proxy.num_measured());
  float nearest = std::numeric_limits<float>::infinity();
  std::size_t at = 0;
  for (std::size_t i = 0; i < hypothesis.source_nodes.size(); ++i) {
    const float distance = source.proxy.node_distance(from, hypothesis.source_nodes[i]);
    if (distance >= nearest) continue;
    nearest = distance;
    at = i;
  }
  return target.proxy.node_distance(onto, hypothesis.target_nodes[at]) <= nearest + slack;
}

std::vector<int> starting_vertices(const Hypothesis& hypothesis, const Proxy& source,
                                   const Proxy& target, const elastic::Projection& surface,
                                   int count) {
  if (!hypothesis.pose) return node_vertices(target, densify(source, target, hypothesis, count));
  std::vector<elastic::Foot> feet;
  for (int i = 0; i < count; ++i)
    feet.push_back(surface((*hypothesis.pose)(source.node_position(i)),
                           hypothesis.pose->rotation * source.node_normal(i),
                           source.features[source.nodes[i]]));
  return nearest_vertices(target.mesh, feet);
}

std::vector<bool> covered_nodes(const Hypothesis& hypothesis, const Pyramid& source,
                                const Pyramid& target, int count, const Options& options) {
  if (!options.parts) return {};
  std::vector<bool> covered(count);
  const double reach =
      options.partial.landmark_reach * std::sqrt(std::min(source.area(), target.area()));
  for (int i = 0; i < count; ++i)
    covered[i] = std::ranges::any_of(hypothesis.source_nodes, [&](int node) {
      return source.proxy.node_distance(node, i) < reach;
    });
  return covered;
}

void sort_by_cost(std::vector<Judged>& judged) {
  std::ranges::stable_sort(judged, {}, &Judged::cost);
}

}  // namespace isomatch::tracked
