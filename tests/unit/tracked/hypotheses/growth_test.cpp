// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/growth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

using test::Prepared;

std::vector<int> first_numbers(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// By how many radians the turn at landmark `a` from `b` to `c` is not that of the plane.
double turn_error(const Proxy& proxy, const NodeDirections& landmarks, int a, int b, int c) {
  const auto planar = [&](int to) {
    const Point offset = proxy.node_position(to) - proxy.node_position(a);
    return std::complex<double>(offset.x(), offset.y());
  };
  const auto seen = [&](int to) { return std::complex<double>(landmarks.direction(a, to)); };
  return std::abs(std::arg(seen(c) / seen(b) * planar(b) / planar(c)));
}

TEST(NodeDirections, SeeOthersInTheDirectionsOfThePlane) {
  const Proxy proxy = Prepared(test::sheet(30, 30)).proxy;
  const NodeDirections landmarks(proxy, first_numbers(60));
  double sum = 0, largest = 0;
  int count = 0;
  for (int a = 0; a < 60; ++a) {
    // At the boundary gradients are one-sided.
    if (proxy.node_position(a).cwiseAbs().maxCoeff() > 0.4) continue;
    for (int b = 0; b < 60; ++b) {
      for (int c = 0; c < 60; ++c) {
        // Nearby, distances bend within a triangle.
        if (std::min(landmarks.distance(a, b), landmarks.distance(a, c)) < 0.2) continue;
        const double error = turn_error(proxy, landmarks, a, b, c);
        sum += error;
        largest = std::max(largest, error);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 1000);
  // Directions follow from distances with an error of .2 %, between vertices 1/30 apart.
  EXPECT_LT(sum / count, 0.1);
  EXPECT_LT(largest, 0.4);
}

TEST(NodeDirections, KnowTheDistancesOfTheirNodes) {
  const Proxy proxy = Prepared(test::icosphere(3)).proxy;
  const std::vector<int> nodes{5, 17, 3, 99};
  const NodeDirections landmarks(proxy, nodes);
  ASSERT_EQ(landmarks.size(), 4);
  for (int a = 0; a < 4; ++a) {
    EXPECT_EQ(landmarks.node(a), nodes[a]);
    for (int b = 0; b < 4; ++b) {
      EXPECT_EQ(landmarks.distance(a, b), proxy.node_distance(nodes[a], nodes[b]));
      EXPECT_EQ(landmarks.distances_from(a)[b], landmarks.distance(a, b));
      EXPECT_NEAR(std::abs(landmarks.direction(a, b)), a == b ? 0 : 1, 1e-5);
    }
  }
}

constexpr int kLandmarks = 80;

/// NodeDirections of a creature and of its mirror image, at the same vertices.
class GrowthTest : public testing::Test {
 protected:
  static NodeDirections landmarks(const Prepared& prepared) {
    return {prepared.proxy, first_numbers(kLandmarks)};
  }

  /// The landmark of the mirror image at the same vertex of the input as each landmark of the
  /// creature, none where there is none.
  std::vector<int> mirror_map() const {
    std::vector<int> vertices;
    for (int i = 0; i < mirrored_.proxy.num_measured(); ++i)
      vertices.push_back(input_vertex(mirrored_, i));
    std::vector<int> map;
    for (int i = 0; i < kLandmarks; ++i)
      map.push_back(static_cast<int>(std::ranges::find(vertices, input_vertex(creature_, i)) -
                                     vertices.begin()));
    return map;
  }

  static int input_vertex(const Prepared& prepared, int node) {
    const int vertex = prepared.proxy.detail_vertex[prepared.proxy.nodes[node]];
    return prepared.surface.input_vertex[vertex];
  }

  const Mesh mesh_ = synthesize({.vertices = 1000, .pose = 3}).mesh;
  const Prepared creature_{mesh_};
  const Prepared mirrored_{test::mirrored(mesh_)};
  const NodeDirections landmarks_ = landmarks(creature_);
  const std::vector<int> identity_ = first_numbers(kLandmarks);
};

TEST_F(GrowthTest, OntoItselfGivesTheIdentity) {
  Growth growth(landmarks_, kLandmarks, landmarks_, kLandmarks, {});
  LandmarkMap map = growth.grow({{0, 0}, {1, 1}, {2, 2}, {3, 3}});
  EXPECT_EQ(map.target_of_source, identity_);
  growth.revise(map);
  EXPECT_EQ(map.target_of_source, identity_);
  growth.measure(map);
  EXPECT_EQ(map.distortion, 0);
  EXPECT_GT(map.orientation, 0.3);
}

TEST_F(GrowthTest, KeepsTheMatchesItBeganWith) {
  Growth growth(landmarks_, kLandmarks, landmarks_, kLandmarks, {});
  const LandmarkMap map = growth.grow({{5, 9}, {7, 2}, {20, 40}, {31, 31}});
  EXPECT_EQ(map.target_of_source[5], 9);
  EXPECT_EQ(map.target_of_source[7], 2);
  EXPECT_EQ(map.target_of_source[20], 40);
  EXPECT_EQ(map.target_of_source[31], 31);
  for (int target : map.target_of_source) {
    EXPECT_GE(target, 0);
    EXPECT_LT(target, kLandmarks);
  }
}

TEST_F(GrowthTest, RevisionRepairsALandmark) {
  Growth growth(landmarks_, kLandmarks, landmarks_, kLandmarks, {});
  LandmarkMap map{identity_};
  map.target_of_source[10] = 3;
  map.target_of_source[50] = 0;
  growth.revise(map);
  EXPECT_EQ(map.target_of_source, identity_);
}

TEST_F(GrowthTest, UsesAsManyLandmarksAsItIsTold) {
  Growth growth(landmarks_, 30, landmarks_, 50, {});
  const LandmarkMap map = growth.grow({{0, 0}, {1, 1}, {2, 2}, {3, 3}});
  EXPECT_EQ(map.target_of_source, first_numbers(30));
}

TEST_F(GrowthTest, DistortionIsTheMeanDifferenceOfDistances) {
  test::Random random(1);
  std::vector<int> targets = random.permutation(kLandmarks);
  double sum = 0;
  for (int i = 0; i < kLandmarks; ++i)
    for (int j = 0; j < kLandmarks; ++j)
      sum += std::abs(landmarks_.distance(i, j) - landmarks_.distance(targets[i], targets[j]));
  LandmarkMap map{targets};
  Growth(landmarks_, kLandmarks, landmarks_, kLandmarks, {}).measure(map);
  EXPECT_NEAR(map.distortion, sum / (kLandmarks * kLandmarks), 1e-4);
  EXPECT_LT(std::abs(map.orientation), 0.3);
}

TEST_F(GrowthTest, OrientationOfAMirrorImageIsReversed) {
  const int count = mirrored_.proxy.num_measured();
  const NodeDirections all(mirrored_.proxy, first_numbers(count));
  LandmarkMap map{mirror_map()};
  for (int target : map.target_of_source) ASSERT_LT(target, count);
  Growth(landmarks_, kLandmarks, all, count, {}).measure(map);
  EXPECT_LT(map.distortion, 1e-5);
  EXPECT_LT(map.orientation, -0.3);
}

}  // namespace
}  // namespace isomatch::tracked
