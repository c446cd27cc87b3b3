// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "isomatch/error.h"
#include "isomatch/mesh/synth.h"
#include "support/context.h"
#include "support/maps.h"
#include "support/shapes.h"
#include "support/transforms.h"

namespace isomatch::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Fit fit_between(const Mesh& source, const Mesh& target, const SurfaceMap& map,
                const FitOptions& options = {}) {
  return judge_fit(Shape(source), Shape(target), map, options);
}

/// Each vertex of `a` goes to the vertex of `b` whose place at rest is nearest to its own, or to
/// that of its mirror image.
SurfaceMap true_map(const SynthShape& a, const SynthShape& b, bool mirrored = false) {
  VertexMap map;
  for (Point p : a.rest) {
    if (mirrored) p[0] = -p[0];
    const auto distance = [&](const Point& q) { return (p - q).squaredNorm(); };
    map.push_back(
        static_cast<int>(std::ranges::min_element(b.rest, {}, distance) - b.rest.begin()));
  }
  return corner_points(b.mesh, map);
}

/// Two poses of a creature of 1,500 vertices.
class Fits : public testing::Test {
 protected:
  static SynthShape creature(int pose) {
    return synthesize({.vertices = 1500, .pose = pose, .seed = 4});
  }

  Fit judged(const SurfaceMap& map, const FitOptions& options = {}) const {
    return fit_between(source_.mesh, target_.mesh, map, options);
  }

  const SynthShape source_ = creature(1), target_ = creature(2);
};

TEST_F(Fits, IdentityChangesNothing) {
  const Fit fit = fit_between(source_.mesh, source_.mesh, identity_map(source_.mesh));
  EXPECT_EQ(fit.grade, FitGrade::kGood);
  EXPECT_THAT(fit.reasons, ElementsAre());
  EXPECT_NEAR(fit.measures.stretch, 0, 1e-6);
  EXPECT_EQ(fit.measures.distorted, 0);
  EXPECT_NEAR(fit.measures.displacement, 0, 1e-6);
  EXPECT_NEAR(fit.measures.relief, 1, 1e-9);
  EXPECT_EQ(fit.measures.unreached, 0);
  EXPECT_EQ(fit.measures.unmatched, 0);
  EXPECT_EQ(fit.measures.reversed, 0);
}

TEST_F(Fits, TheTruthIsGood) {
  const Fit fit = judged(true_map(source_, target_));
  EXPECT_EQ(fit.grade, FitGrade::kGood) << testing::PrintToString(fit.reasons);
}

TEST_F(Fits, ALeftRightFlipIsPoorUnlessItIsAskedFor) {
  const SurfaceMap flip = true_map(source_, target_, true);
  const Fit fit = judged(flip);
  EXPECT_EQ(fit.grade, FitGrade::kPoor);
  EXPECT_THAT(fit.reasons.front(), HasSubstr("turns the surface over"));
  EXPECT_GT(fit.measures.reversed, 0.9);
  EXPECT_EQ(judged(flip, {.mirrored = true}).grade, FitGrade::kGood);
}

TEST_F(Fits, AMapToOnePlaceIsPoor) {
  const Fit fit = judged(corner_points(
      target_.mesh, VertexMap(static_cast<std::size_t>(source_.mesh.num_vertices()), 7)));
  EXPECT_EQ(fit.grade, FitGrade::kPoor);
  EXPECT_GT(fit.measures.distorted, 0.9);
  EXPECT_GT(fit.measures.unreached, 0.9);
}

TEST_F(Fits, APartWithoutImageIsNamed) {
  SurfaceMap map = true_map(source_, target_);
  for (std::size_t v = 0; v < map.size(); ++v)
    if (source_.rest[v][2] > 0) map[v] = {};
  const Fit fit = judged(map);
  EXPECT_EQ(fit.grade, FitGrade::kPoor);
  EXPECT_GT(fit.measures.unmatched, 0.3);
  EXPECT_GT(fit.measures.unreached, 0.3);
  EXPECT_EQ(fit.measures.distorted, 0);
}

TEST_F(Fits, ASparseMapIsJudgedByWhatItHas) {
  SurfaceMap map = true_map(source_, target_);
  for (std::size_t v = 0; v < map.size(); ++v)
    if (v % 10 != 0) map[v] = {};
  EXPECT_EQ(judged(map).grade, FitGrade::kGood) << testing::PrintToString(judged(map).reasons);
}

TEST_F(Fits, ThatNothingIsMatchedIsPoor) {
  const Fit fit = judged(SurfaceMap(static_cast<std::size_t>(source_.mesh.num_vertices())));
  EXPECT_EQ(fit.grade, FitGrade::kPoor);
  EXPECT_EQ(fit.measures.unmatched, 1);
  EXPECT_EQ(fit.measures.reversed, -1);
}

TEST_F(Fits, ExchangedEndsAreNoticed) {
  // What lies in front is sent behind, and the other way round.
  SynthShape turned = source_;
  for (Point& p : turned.rest) p = {-p[0], p[1], -p[2]};
  EXPECT_NE(judged(true_map(turned, target_)).grade, FitGrade::kGood);
}

TEST_F(Fits, DoNotDependOnUnitsNorThreads) {
  const SurfaceMap map = true_map(source_, target_);
  const Shape from(scaled(source_.mesh, 1e-30)), onto(scaled(target_.mesh, 1e20));
  const FitMeasures one = judge_fit(from, onto, map, {}, with_threads(1)).measures;
  const FitMeasures three = judge_fit(from, onto, map, {}, with_threads(3)).measures;
  const FitMeasures plain = judged(map).measures;
  EXPECT_EQ(one.stretch, three.stretch);
  EXPECT_EQ(one.displacement, three.displacement);
  EXPECT_EQ(one.relief, three.relief);
  EXPECT_NEAR(one.stretch, plain.stretch, 1e-5);
  EXPECT_NEAR(one.relief, plain.relief, 1e-5);
  EXPECT_NEAR(one.reversed, plain.reversed, 1e-5);
}

TEST(FitOfSheets, AStretchedSheetIsStretched) {
  // At equal area lengths change by sqrt(4) along the one side and by its inverse along the other.
  const Mesh square = sheet(30, 30), strip = sheet(30, 30, 4, 1);
  const FitMeasures measures = fit_between(square, strip, identity_map(square)).measures;
  EXPECT_GT(measures.stretch, 0.3);
  EXPECT_LT(measures.stretch, std::log(2));
}

TEST(FitOfSheets, WhatIsFlatHasNoRelief) {
  const Mesh square = sheet(30, 30);
  EXPECT_EQ(fit_between(square, square, identity_map(square)).measures.relief, 1);
}

TEST(FitErrors, AMapOfAnotherMeshIsRefused) {
  const Shape sphere(icosphere(2)), small(icosphere(1));
  EXPECT_THROW(judge_fit(sphere, sphere, identity_map(small.mesh())), InvalidInput);
  EXPECT_THROW(judge_fit(sphere, small, identity_map(sphere.mesh())), InvalidInput);
}

}  // namespace
}  // namespace isomatch::test
