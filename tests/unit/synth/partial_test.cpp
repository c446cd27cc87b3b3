// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "isomatch/error.h"
#include "isomatch/maps/correspondence.h"
#include "isomatch/mesh/synth.h"
#include "isomatch/shape/diagnosis.h"

namespace isomatch {
namespace {

/// `options` without what removes parts.
SynthOptions whole(SynthOptions options) {
  options.cut = 0;
  options.holes = 0;
  return options;
}

/// The vertex of each place on the rest pose, where no two vertices coincide.
class Places {
 public:
  explicit Places(const SynthShape& shape) {
    for (int v = 0; v < shape.mesh.num_vertices(); ++v) vertex_[key(shape.rest[v])] = v;
  }

  int vertex_at(const Point& place) const {
    const auto found = vertex_.find(key(place));
    return found == vertex_.end() ? kUnmatched : found->second;
  }

 private:
  using Key = std::tuple<double, double, double>;
  static Key key(const Point& p) { return {p.x(), p.y(), p.z()}; }

  std::map<Key, int> vertex_;
};

double removed_share(const SynthShape& part, const SynthShape& uncut) {
  return 1 - surface_area(part.mesh) / surface_area(uncut.mesh);
}

class PartialSynth : public testing::TestWithParam<SynthOptions> {};

TEST_P(PartialSynth, IsOneSoundPieceWithBorders) {
  const MeshDiagnosis diagnosis = diagnose(synthesize(GetParam()).mesh);
  EXPECT_EQ(diagnosis.given.components, 1);
  EXPECT_EQ(diagnosis.given.genus(), 0);
  EXPECT_EQ(diagnosis.given.nonmanifold_vertices, 0);
  EXPECT_EQ(diagnosis.unreferenced_vertices, 0);
  EXPECT_GT(diagnosis.given.boundary_loops, 0);
}

TEST_P(PartialSynth, KeepsTheVerticesOfTheUncutShapeInTheirOrder) {
  const SynthShape part = synthesize(GetParam()), uncut = synthesize(whole(GetParam()));
  const Places places(uncut);
  int previous = -1;
  for (int v = 0; v < part.mesh.num_vertices(); ++v) {
    const int original = places.vertex_at(part.rest[v]);
    ASSERT_GT(original, previous);
    EXPECT_EQ(part.mesh.vertices[v], uncut.mesh.vertices[original]);
    previous = original;
  }
}

TEST_P(PartialSynth, TruthsNameTheSameVerticesAndWhatIsGone) {
  const SynthShape part = synthesize(GetParam()), uncut = synthesize(whole(GetParam()));
  const Places places(part);
  for (const auto truth : {&SynthShape::ground_truth, &SynthShape::symmetric_ground_truth}) {
    ASSERT_EQ((part.*truth).size(), kSynthTemplatePoints);
    for (int i = 0; i < kSynthTemplatePoints; ++i)
      EXPECT_EQ((part.*truth)[i], places.vertex_at(uncut.rest[(uncut.*truth)[i]]));
    EXPECT_GT(std::ranges::count(part.*truth, kUnmatched), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Creatures, PartialSynth,
                         testing::Values(SynthOptions{"creature", 1000, 1, 2, 0.95, 0},
                                         SynthOptions{"creature", 1000, 3, 1, 0, 3},
                                         SynthOptions{"creature", 3000, 2, 2, 0.4, 0},
                                         SynthOptions{"creature", 3000, 4, 5, 0.3, 4}));

TEST(SynthCut, RemovesTheShareOfTheArea) {
  for (const int pose : {0, 3}) {
    const SynthShape uncut = synthesize({"creature", 3000, pose, 4});
    for (const double share : {0.1, 0.4, 0.8}) {
      const SynthShape part = synthesize({"creature", 3000, pose, 4, share});
      // One percent is the cut's tolerance, the rest are faces around pinched vertices.
      EXPECT_NEAR(removed_share(part, uncut), share, 0.02) << "pose " << pose;
    }
  }
}

TEST(SynthCut, DiffersFromPoseToPoseAndNotFromRunToRun) {
  const SynthOptions options{"creature", 2000, 1, 2, 0.4, 2};
  const SynthShape a = synthesize(options), again = synthesize(options);
  EXPECT_EQ(a.mesh.vertices, again.mesh.vertices);
  EXPECT_EQ(a.mesh.faces, again.mesh.faces);
  EXPECT_EQ(a.ground_truth, again.ground_truth);

  SynthOptions other = options;
  other.pose = 2;
  const SynthShape b = synthesize(other);
  int on_one_only = 0;
  for (int i = 0; i < kSynthTemplatePoints; ++i)
    on_one_only += (a.ground_truth[i] == kUnmatched) != (b.ground_truth[i] == kUnmatched);
  // Cuts in the same place would differ by some points along their borders.
  EXPECT_GT(on_one_only, kSynthTemplatePoints / 20);
}

TEST(SynthHoles, AreAsManyBordersOfTheRadius) {
  for (const int pose : {1, 2}) {
    const SynthOptions options{.vertices = 5000, .pose = pose, .seed = 3, .holes = 6};
    const SynthShape uncut = synthesize(whole(options)), part = synthesize(options);
    EXPECT_EQ(diagnose(part.mesh).given.boundary_loops, 6);
    // Disks of radius .05 sqrt(area) if flat; less at the tips of limbs, more or less by curvature.
    const double disks = 6 * std::numbers::pi * 0.05 * 0.05;
    EXPECT_NEAR(removed_share(part, uncut), disks, 0.25 * disks) << "pose " << pose;
  }
}

TEST(SynthHoles, StayApartFromTheCut) {
  const SynthOptions cut{.vertices = 5000, .pose = 2, .seed = 2, .cut = 0.4};
  SynthOptions both = cut;
  both.holes = 3;
  EXPECT_EQ(diagnose(synthesize(both).mesh).given.boundary_loops,
            diagnose(synthesize(cut).mesh).given.boundary_loops + 3);
}

TEST(SynthHoles, WithoutRoomAreRejected) {
  EXPECT_THROW(synthesize({.vertices = 1000, .holes = 500}), InvalidInput);
}

TEST(SynthPartialOptions, OutOfRangeAreRejected) {
  EXPECT_THROW(synthesize({.cut = -0.1}), InvalidInput);
  EXPECT_THROW(synthesize({.cut = 1}), InvalidInput);
  EXPECT_THROW(synthesize({.cut = std::nan("")}), InvalidInput);
  EXPECT_THROW(synthesize({.holes = -1}), InvalidInput);
}

}  // namespace
}  // namespace isomatch
