// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/ends.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "tracked/hypotheses/seeds.h"
#include "tracked/shape/pyramid.h"

namespace isomatch::tracked {
namespace {

Options small_options() {
  Options options;
  options.pyramid.proxy = {.vertices = 2000, .nodes = 600, .measured_nodes = 200};
  options.pyramid.middle_nodes = 200;
  return options;
}

/// Maps of a creature to itself.
class EndsTest : public testing::Test {
 protected:
  EndsTest()
      : creature_(make_pyramid(PreparedShape(synthesize({.vertices = 3000, .pose = 1}).mesh, {}),
                               {}, options_.pyramid, {})) {}

  Track track(std::vector<int> vertices) const {
    return refinement_.fine_rounds({{}, 0, &creature_}, std::move(vertices), {},
                                   options_.rounds - 1);
  }

  std::vector<int> identity() const {
    std::vector<int> nodes = creature_.proxy.nodes;
    nodes.resize(creature_.fine.size());
    return nodes;
  }

  /// The nodes at the end of a limb.
  std::vector<int> end_at(int tip) const {
    std::vector<int> nodes;
    for (int i = 0; i < creature_.fine.size(); ++i)
      if (creature_.proxy.distances(tip, creature_.proxy.nodes[i]) < kEnd) nodes.push_back(i);
    return nodes;
  }

  /// The identity, but for an end that is turned by half about its axis.
  std::vector<int> with_turned(int tip) const {
    const std::vector<int> end = end_at(tip);
    const std::vector<Point>& vertices = creature_.proxy.mesh.vertices;
    Point centre(0, 0, 0);
    for (const int i : end)
      centre += creature_.proxy.node_position(i) / static_cast<double>(end.size());
    const Eigen::AngleAxisd turn(std::numbers::pi,
                                 (creature_.proxy.node_position(tip) - centre).normalized());
    std::vector<int> map = identity();
    for (const int i : end) {
      const Point place = centre + turn * (creature_.proxy.node_position(i) - centre);
      const auto distance = [&](const Point& p) { return (p - place).norm(); };
      map[i] =
          static_cast<int>(std::ranges::min_element(vertices, {}, distance) - vertices.begin());
    }
    return map;
  }

  double mean_error(const Track& track, const std::vector<int>& nodes) const {
    double sum = 0;
    for (const int i : nodes)
      sum += (track.registration.feet[i].position - creature_.proxy.node_position(i)).norm();
    return sum / static_cast<double>(nodes.size());
  }

  static constexpr double kEnd = 0.13;
  const Options options_ = small_options();
  const Pyramid creature_;
  const Refinement refinement_{creature_, options_};
};

TEST_F(EndsTest, LeavesTheIdentityAlone) {
  Track track = this->track(identity());
  const std::vector<Point> before = track.deformation.positions();
  refinement_.turn_an_end(track);
  EXPECT_EQ(track.deformation.positions(), before);
}

TEST_F(EndsTest, TurnsEndsBack) {
  double before = 0, after = 0;
  for (const int tip : extremities(creature_.proxy, options_.hypotheses.seeds)) {
    const std::vector<int> end = end_at(tip);
    Track track = this->track(with_turned(tip));
    const double error = mean_error(track, end);
    refinement_.turn_an_end(track);
    EXPECT_LE(mean_error(track, end), error);
    before += error;
    after += mean_error(track, end);
  }
  EXPECT_LT(after, 0.75 * before);
}

}  // namespace
}  // namespace isomatch::tracked
