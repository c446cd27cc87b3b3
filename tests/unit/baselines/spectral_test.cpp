// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/spectral.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "isomatch/error.h"
#include "pairs.h"
#include "spectral/eigenvector_order.h"
#include "spectral/embedding.h"
#include "spectral/thin_plate.h"
#include "support/context.h"

namespace isomatch::baselines {
namespace {

constexpr int kLevel = 3;

/// Base vertices of both shapes, in the numbers of the surfaces.
JointSampling surface_bases(const test::KnownPair& pair) {
  const JointSampling bases = sample_jointly(pair.source, pair.target, kLevel);
  return {*on_surface(pair.source_surface().surface(), bases.source, "base"),
          *on_surface(pair.target_surface().surface(), bases.target, "base")};
}

TEST(Spectral, FindsARelabelledShape) {
  const test::KnownPair pair = test::relabelled_pair(1000);
  const JointSampling bases = surface_bases(pair);
  const SpectralResult result = match_spectral(pair.source_surface(), pair.target_surface(), bases);
  ASSERT_EQ(result.base_matches.size(), bases.source.size());
  Correspondence matches;
  for (std::size_t i = 0; i < bases.source.size(); ++i)
    matches.push_back({bases.source[i], bases.target[result.base_matches[i]]});
  std::ranges::sort(matches);
  // Rounding may decide which of two equally salient vertices becomes a base.
  EXPECT_LT(pair.error(SurfaceMatches(matches)), 0.01);
  EXPECT_LT(pair.error(test::surface_matches(result.source_to_target)), 0.01);
}

TEST(Spectral, ThreadsChangeNothing) {
  const test::KnownPair pair = test::posed_pair(1000);
  const JointSampling bases = surface_bases(pair);
  const auto matched = [&](int threads) {
    return match_spectral(pair.source_surface(), pair.target_surface(), bases, {},
                          test::with_threads(threads));
  };
  EXPECT_EQ(matched(1).source_to_target, matched(3).source_to_target);
}

TEST(Spectral, RejectsWhatItCannotDo) {
  const test::KnownPair pair = test::relabelled_pair(1000);
  EXPECT_THROW(match_spectral(pair.source_surface(), pair.target_surface(), {{0, 1, 2}, {0, 1, 2}}),
               InvalidInput);
  EXPECT_THROW((SpectralOptions{.dimensions = 7}.validate()), InvalidInput);
  EXPECT_THROW((SpectralOptions{.last_smoothing = 0}.validate()), InvalidInput);
}

TEST(Embedding, ExtendsTheBases) {
  const MetricSurface shape = test::relabelled_pair(1000).source_surface();
  const std::vector<int> bases{3, 100, 200, 300, 400, 500, 600, 700, 800, 900};
  const Embedding embedding = embed(shape, bases, 4, {});
  for (std::size_t i = 0; i < bases.size(); ++i)
    EXPECT_LT((embedding.vertices.row(bases[i]) - embedding.bases.row(i)).norm(), 1e-4);
}

TEST(EigenvectorOrder, UndoesASignedPermutation) {
  const Eigen::MatrixXd target = Eigen::MatrixXd::Random(40, 4);
  Eigen::MatrixXd source(40, 4);
  source << target.col(2), -target.col(0), target.col(1), -target.col(3);
  const SignedOrder order = best_signed_order(source, target, test::with_threads(2));
  EXPECT_LT((order.applied(source) - target).norm(), 1e-9);
}

TEST(ThinPlateSpline, ReproducesAffineMapsHoweverSmooth) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(30, 3);
  const Eigen::MatrixXd images = points * Eigen::MatrixXd::Random(3, 3) +
                                 Eigen::VectorXd::Ones(30) * Eigen::RowVector3d(1, 2, 3);
  const ThinPlateSpline spline(points.topRows(20), images.topRows(20), 10);
  EXPECT_LT((spline(points) - images).norm(), 1e-9);
}

TEST(ThinPlateSpline, InterpolatesWithoutSmoothing) {
  const Eigen::MatrixXd points = Eigen::MatrixXd::Random(30, 3);
  const Eigen::MatrixXd values = Eigen::MatrixXd::Random(30, 3);
  EXPECT_LT((ThinPlateSpline(points, values, 0)(points) - values).norm(), 1e-6);
}

}  // namespace
}  // namespace isomatch::baselines
