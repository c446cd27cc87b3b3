// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/context.h"
#include "support/mesh_files.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "unit/tracked/matched_pair.h"

namespace isomatch {
namespace {

using TrackedInvariance = test::CreaturePair;

TEST_F(TrackedInvariance, ThreadsChangeNothing) {
  const auto matched = [&](int threads) {
    const Context context = test::with_threads(threads);
    return match_tracked(Shape(pair_.source), Shape(pair_.target), test::with_alternatives(1),
                         context);
  };
  const TrackedResult one = matched(1), three = matched(3);
  ASSERT_EQ(one.maps.size(), three.maps.size());
  for (std::size_t k = 0; k < one.maps.size(); ++k) {
    const TrackedMap &a = one.maps[k], &b = three.maps[k];
    EXPECT_EQ(a.source_to_target, b.source_to_target);
    EXPECT_EQ(a.target_to_source, b.target_to_source);
    EXPECT_EQ(a.registered, b.registered);
    EXPECT_EQ(a.energy, b.energy);
    EXPECT_EQ(a.distance, b.distance);
    EXPECT_EQ(a.deviation, b.deviation);
    EXPECT_EQ(a.distortion, b.distortion);
    EXPECT_EQ(a.orientation, b.orientation);
  }
  EXPECT_EQ(one.ambiguity, three.ambiguity);
  EXPECT_TRUE(
      std::ranges::equal(one.hypotheses, three.hypotheses, [](const auto& a, const auto& b) {
        return a.distortion == b.distortion && a.orientation == b.orientation &&
               a.coarse_energy == b.coarse_energy;
      }));
}

TEST_F(TrackedInvariance, UnitsBeyondTheRangeOf32BitsChangeNothing) {
  for (const double unit : {std::exp2(-200), std::exp2(200)}) {
    const Shape source(test::scaled(pair_.source, unit));
    const Shape target(test::scaled(pair_.target, 1 / unit));
    EXPECT_EQ(match_tracked(source, target).maps.front().source_to_target, map_.source_to_target);
  }
}

TEST_F(TrackedInvariance, ScaleAndPositionDoNotMatter) {
  test::Random random(1);
  test::TruePair moved = pair_;
  moved.source = test::scaled(test::moved(pair_.source, random), 7);
  moved.target = test::scaled(test::moved(pair_.target, random), 0.01);
  expect_as_plain(moved);
}

TEST_F(TrackedInvariance, NumbersDoNotMatter) {
  test::Random random(1);
  const test::Relabelled source = test::relabelled(pair_.source, random);
  const test::Relabelled target = test::relabelled(pair_.target, random);
  test::TruePair relabelled{source.mesh, target.mesh, pair_.source_truth, pair_.target_truth,
                            pair_.mirrored_target_truth};
  for (int& v : relabelled.source_truth) v = source.new_vertex[v];
  for (int& v : relabelled.target_truth) v = target.new_vertex[v];
  for (int& v : relabelled.mirrored_target_truth) v = target.new_vertex[v];
  expect_as_plain(relabelled);
}

TEST_F(TrackedInvariance, MirrorImagesOfBothAreMatchedAsThey) {
  test::TruePair mirrored = pair_;
  mirrored.source = test::mirrored(pair_.source);
  mirrored.target = test::mirrored(pair_.target);
  expect_as_plain(mirrored);
}

TEST_F(TrackedInvariance, MirrorImageIsMatchedLeftToRight) {
  test::TruePair mirrored = pair_;
  mirrored.target = test::mirrored(pair_.target);
  const test::Errors errors = test::matched_errors(mirrored);
  EXPECT_LT(errors.mirrored, 0.03);
  EXPECT_LT(errors.mirrored, 0.3 * errors.direct);
}

TEST_F(TrackedInvariance, FacesTurnedOverDoNotMatter) {
  const auto turned = [](Mesh mesh) {
    for (Face& face : mesh.faces) std::swap(face[1], face[2]);
    return mesh;
  };
  const Shape source(turned(pair_.source)), target(turned(pair_.target));
  for (const auto& [from, onto] :
       {std::pair{&source_, &target}, {&source, &target_}, {&source, &target}}) {
    const TrackedResult result = match_tracked(*from, *onto);
    test::expect_sound(result, *from, *onto);
    const TrackedMap& map = result.maps.front();
    EXPECT_LT(test::mean_distance(test::places(*onto, map.source_to_target),
                                  test::places(target_, map_.source_to_target)),
              1e-3);
    EXPECT_LT(test::mean_distance(test::places(*from, map.target_to_source),
                                  test::places(source_, map_.target_to_source)),
              1e-3);
  }
}

TEST_F(TrackedInvariance, SmallComponentsAreLeftOut) {
  test::TruePair pair = pair_;
  pair.source = test::combined(pair_.source, test::scaled(test::tetrahedron(), 0.01));
  const Mesh part = test::scaled(test::icosphere(1), 0.1);
  pair.target = test::combined(part, pair_.target);
  for (int& v : pair.target_truth) v += part.num_vertices();
  for (int& v : pair.mirrored_target_truth) v += part.num_vertices();
  expect_as_plain(pair);
}

TEST_F(TrackedInvariance, SaysWhenASurfaceHasNoOutside) {
  Mesh turned = pair_.source;
  test::Random random(1);
  for (Face& face : turned.faces)
    if (random.uniform() < 0.5) std::swap(face[0], face[1]);
  const Shape source(turned);
  const TrackedResult result = match_tracked(source, target_);
  EXPECT_FALSE(result.oriented);
  test::expect_sound(result, source, target_);
}

}  // namespace
}  // namespace isomatch
