// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "zoomout/zoomout.h"

#include <gtest/gtest.h>

#include "isomatch/error.h"
#include "pairs.h"
#include "support/context.h"
#include "support/metric_surface.h"
#include "support/shapes.h"
#include "zoomout/orientation_operator.h"
#include "zoomout/wave_kernel.h"

namespace isomatch::baselines {
namespace {

TEST(ZoomOut, FindsARelabelledShape) {
  const test::KnownPair pair = test::relabelled_pair(1500);
  const ZoomOutResult result = match_zoomout(pair.source_surface(), pair.target_surface());
  ASSERT_EQ(std::ssize(result.source_to_target), pair.source.num_surface_vertices());
  // Rounding of eigenfunctions may exchange close neighbours; an edge is .03 long.
  EXPECT_LT(pair.error(test::surface_matches(result.source_to_target)), 0.003);
}

TEST(ZoomOut, MatchesPosesWithoutAFlip) {
  const test::KnownPair pair = test::posed_pair(1500);
  // The truth is off by up to half an edge, .015, on either side.
  const ZoomOutResult result = match_zoomout(pair.source_surface(), pair.target_surface());
  EXPECT_LT(pair.error(test::surface_matches(result.source_to_target)), 0.03);
}

TEST(ZoomOut, ThreadsChangeNothing) {
  const test::KnownPair pair = test::posed_pair(1000);
  const auto matched = [&](int threads) {
    return match_zoomout(pair.source_surface(), pair.target_surface(), {},
                         test::with_threads(threads))
        .source_to_target;
  };
  EXPECT_EQ(matched(1), matched(3));
}

ZoomOutOptions with(int ZoomOutOptions::*option, int value) {
  ZoomOutOptions options;
  options.*option = value;
  return options;
}

TEST(ZoomOut, RejectsWhatItCannotDo) {
  const MetricSurface small = test::metric_surface(test::icosphere(1));
  EXPECT_THROW(match_zoomout(small, small), InvalidInput);
  EXPECT_THROW(with(&ZoomOutOptions::step, 0).validate(), InvalidInput);
  EXPECT_THROW(with(&ZoomOutOptions::energies, 1).validate(), InvalidInput);
  EXPECT_THROW(with(&ZoomOutOptions::signature_functions, 10).validate(), InvalidInput);
  EXPECT_THROW(with(&ZoomOutOptions::samples, 10).validate(), InvalidInput);
}

TEST(OrientationOperator, ChangesSignUnderAMirror) {
  const Mesh mesh = test::rough_sphere(2, 0.2, 1), image = test::mirrored(mesh);
  const Eigen::MatrixXd functions = Eigen::MatrixXd::Random(mesh.num_vertices(), 4);
  const Eigen::VectorXd function = Eigen::VectorXd::Random(mesh.num_vertices());
  const Eigen::MatrixXd one = orientation_operator(mesh, functions, function);
  const Eigen::MatrixXd other = orientation_operator(image, functions, function);
  EXPECT_GT(one.norm(), 0.1);
  EXPECT_LT((one + other).norm(), 1e-9 * one.norm());
}

TEST(OrientationOperator, IsTheDerivativeAcrossTheGradient) {
  // On the unit square with f = x, v = x and n = z, so that n . (v x grad g) = dg/dy.
  const Mesh sheet = test::sheet(10, 10);
  Eigen::MatrixXd functions(sheet.num_vertices(), 3);
  for (int v = 0; v < sheet.num_vertices(); ++v)
    functions.row(v) << 1, sheet.vertices[v].x(), sheet.vertices[v].y();
  const Eigen::MatrixXd derivative = orientation_operator(sheet, functions, functions.col(1));
  const double sign = derivative(0, 2);
  EXPECT_NEAR(std::abs(sign), 1, 1e-9);
  EXPECT_NEAR(derivative(1, 2), 0.5 * sign, 1e-9);
  EXPECT_LT(derivative.leftCols(2).norm(), 1e-9);
}

TEST(WaveKernel, OfConstantSquaresIsConstant) {
  const Eigen::MatrixXd functions = Eigen::MatrixXd::Constant(5, 30, 2);
  const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(30, 0, 100);
  const Eigen::MatrixXd signatures = wave_kernel_signatures(functions, values, 10);
  EXPECT_LT((signatures.array() - 4).abs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace isomatch::baselines
