// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/reversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "tracked/shape/pyramid.h"

namespace isomatch::tracked {
namespace {

Options small_options() {
  Options options;
  options.pyramid.proxy = {.vertices = 1000, .nodes = 300, .measured_nodes = 200};
  options.pyramid.middle_nodes = 200;
  return options;
}

/// Poses of a creature, in different meshes.
class ReversalTest : public testing::Test {
 protected:
  /// A pose, and for each vertex of its surface the place in the pose that all have in common.
  struct Posed {
    Pyramid pyramid;
    std::vector<Point> rest;

    const Point& rest_of_node(int node) const {
      return rest[pyramid.proxy.detail_vertex[pyramid.proxy.nodes[node]]];
    }
  };

  Posed posed(int pose) const {
    const SynthShape shape = synthesize({.vertices = 1500, .pose = pose});
    const PreparedShape prepared(shape.mesh, {});
    return {make_pyramid(prepared, {}, options_.pyramid, {}),
            selected(shape.rest, prepared.surface()->input_vertex)};
  }

  /// Where a node of the source belongs.
  static const Point& true_place(const Posed& source, const Posed& target, int node) {
    return target.pyramid.surface->mesh.vertices[nearest(target.rest, source.rest_of_node(node))];
  }

  /// A track after some rounds from the true map on.
  Track track(const Posed& source, const Posed& target, int rounds) const {
    std::vector<int> vertices;
    for (int i = 0; i < source.pyramid.fine.size(); ++i)
      vertices.push_back(
          nearest(target.pyramid.proxy.mesh.vertices, true_place(source, target, i)));
    return Refinement(target.pyramid, options_)
        .fine_rounds({{}, 0, &source.pyramid}, vertices, {}, options_.rounds - rounds);
  }

  void settle(Track& track, const Posed& target) const {
    settle_with_reverse(track, Refinement(target.pyramid, options_), target.pyramid, options_);
  }

  static int nearest(const std::vector<Point>& points, const Point& place) {
    const auto distance = [&](const Point& p) { return (p - place).norm(); };
    return static_cast<int>(std::ranges::min_element(points, {}, distance) - points.begin());
  }

  static double mean_error(const Track& track, const Posed& source, const Posed& target) {
    double sum = 0;
    for (int i = 0; i < track.deformation.size(); ++i)
      sum += (track.registration.feet[i].position - true_place(source, target, i)).norm();
    return sum / track.deformation.size();
  }

  const Options options_ = small_options();
};

TEST_F(ReversalTest, LeavesTheIdentityAlone) {
  const Posed shape = posed(1);
  Track track = this->track(shape, shape, 1);
  settle(track, shape);
  EXPECT_LT(mean_error(track, shape, shape), 0.004);
}

TEST_F(ReversalTest, BringsTheMapCloserToTheTruth) {
  double before = 0, after = 0;
  for (int pose = 2; pose < 5; ++pose) {
    const Posed source = posed(1), target = posed(pose);
    Track track = this->track(source, target, 4);
    before += mean_error(track, source, target);
    settle(track, target);
    after += mean_error(track, source, target);
  }
  EXPECT_LT(after, before);
}

TEST_F(ReversalTest, KeepsLandmarks) {
  const Posed source = posed(1), target = posed(2);
  Options options = options_;
  for (const int vertex : {3, 500, 1200})
    options.landmarks->push_back({vertex, nearest(target.rest, source.rest[vertex])});
  Track track = this->track(source, target, 4);
  settle_with_reverse(track, Refinement(target.pyramid, options), target.pyramid, options);
  for (const auto& [s, t] : *options.landmarks) {
    const int node = nearest_node(source.pyramid, s, track.deformation.size());
    EXPECT_LT(
        (track.deformation.positions()[node] - target.pyramid.surface->mesh.vertices[t]).norm(),
        0.05);
  }
}

}  // namespace
}  // namespace isomatch::tracked
