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
#include "tracked/shape/pyramid.h"
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

/// The price and doubt that shapes have of which something may be missing.
GrowthOptions priced() {
  const PartialOptions partial;
  return {.price = partial.landmark_price, .doubt = partial.doubt};
}

TEST_F(GrowthTest, DoubtAndPriceChangeNothingWhereNothingIsMissing) {
  test::Random random(1);
  LandmarkMap plain{random.permutation(kLandmarks)}, doubtful = plain;
  Growth(landmarks_, kLandmarks, landmarks_, kLandmarks, {}).measure(plain);
  Growth growth(landmarks_, kLandmarks, landmarks_, kLandmarks, priced());
  growth.measure(doubtful);
  EXPECT_NEAR(doubtful.distortion, plain.distortion, 1e-5);
  EXPECT_EQ(doubtful.orientation, plain.orientation);
  EXPECT_EQ(growth.grow({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).target_of_source, identity_);
}

TEST_F(GrowthTest, LandmarksThatAreLeftOutCostTheirPrice) {
  LandmarkMap map{identity_};
  for (int i = 0; i < kLandmarks / 4; ++i) map.target_of_source[i] = kUnmatched;
  Growth(landmarks_, kLandmarks, landmarks_, kLandmarks, priced()).measure(map);
  EXPECT_NEAR(map.distortion, PartialOptions{}.landmark_price / 4, 1e-6);
  EXPECT_GT(map.orientation, 0.3);
}

/// A sheet of [0, 2] x [0, 1], and its left half, in one unit of length.
class HalfSheet : public testing::Test {
 protected:
  static Pyramid pyramid(const Mesh& mesh, const View& view) {
    return make_pyramid(PreparedShape(mesh, {}), view, {.proxy = {.nodes = 200}}, {});
  }

  static Point at(const Pyramid& pyramid, int node) {
    return pyramid.surface->scale * pyramid.proxy.node_position(node) + pyramid.surface->centre;
  }

  /// Nodes of the whole in the left half and those next to them of the half, as four matches.
  Correspondence first_matches() const {
    Correspondence matches;
    for (int i = 0; i < kSources && matches.size() < 4; ++i) {
      if (at(whole_, i).x() > 0.8) continue;
      int nearest = 0;
      for (int t = 0; t < kTargets; ++t)
        if ((at(half_, t) - at(whole_, i)).norm() < (at(half_, nearest) - at(whole_, i)).norm())
          nearest = t;
      matches.push_back({i, nearest});
    }
    return matches;
  }

  LandmarkMap grown(const GrowthOptions& options) const {
    const NodeDirections from(whole_.proxy, first_numbers(kSources)),
        onto(half_.proxy, first_numbers(kTargets));
    Growth growth(from, kSources, onto, kTargets, options);
    LandmarkMap map = growth.grow(first_matches());
    growth.revise(map);
    growth.measure(map);
    return map;
  }

  static constexpr int kSources = 60, kTargets = 200;
  const Pyramid whole_ = pyramid(test::sheet(40, 20, 2, 1), {});
  const Pyramid half_ = pyramid(test::sheet(20, 20), {.size = std::sqrt(0.5), .open = true});
};

TEST_F(HalfSheet, LandmarksWithoutCounterpartStayUnmatchedAtAPrice) {
  const LandmarkMap map = grown(priced());
  int left = 0, right = 0;
  for (int i = 0; i < kSources; ++i) {
    const int target = map.target_of_source[i];
    const Point p = at(whole_, i);
    if (p.x() > 1.3) {
      EXPECT_EQ(target, kUnmatched) << p.transpose();
      ++right;
    } else if (p.x() < 0.9) {
      ASSERT_NE(target, kUnmatched) << p.transpose();
      EXPECT_LT((at(half_, target) - p).norm(), 0.15);
      ++left;
    }
  }
  EXPECT_GT(left, 10);
  EXPECT_GT(right, 10);
}

TEST_F(HalfSheet, AllLandmarksAreMatchedWithoutAPrice) {
  const LandmarkMap map = grown({});
  EXPECT_EQ(std::ranges::count(map.target_of_source, kUnmatched), 0);
  EXPECT_GT(map.distortion, grown(priced()).distortion);
}

}  // namespace
}  // namespace isomatch::tracked
