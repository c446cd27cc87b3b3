// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/group/shape_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "isomatch/error.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

using testing::Each;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

CorrespondingPoints of(std::vector<std::vector<Point>> points) { return {std::move(points), {}}; }

std::vector<Point> moved_points(const std::vector<Point>& points, const Similarity& similarity) {
  std::vector<Point> result;
  for (const Point& point : points) result.push_back(similarity.apply(point));
  return result;
}

Similarity any_similarity(test::Random& random, bool keep_size = false) {
  return {keep_size ? 1 : random.uniform(0.2, 5), random.rotation(),
          random.uniform(1, 10) * random.direction()};
}

/// Spheres of different heights: the height is the only mode, and as the products of positions and
/// differences are symmetric, the shapes lie as they do when they are aligned.
std::vector<Point> stretched(double height) {
  std::vector<Point> points = test::icosphere(1).vertices;
  for (Point& point : points) point.z() *= height;
  return points;
}

/// Shapes with this many modes of decreasing size, noise besides.
CorrespondingPoints family(int num_shapes, int num_modes, double noise, std::uint64_t seed,
                           bool keep_size = false) {
  test::Random random(seed);
  const std::vector<Point> base = test::box(2, {1, 2, 3}).vertices;
  std::vector<std::vector<Point>> modes(num_modes, base);
  for (auto& mode : modes)
    for (Point& point : mode) point = random.direction();
  CorrespondingPoints shapes;
  for (int i = 0; i < num_shapes; ++i) {
    std::vector<Point> points = base;
    for (int k = 0; k < num_modes; ++k) {
      const double score = random.uniform(-0.2, 0.2) / (k + 1);
      for (std::size_t p = 0; p < points.size(); ++p) points[p] += score * modes[k][p];
    }
    for (Point& point : points) point += noise * random.uniform() * random.direction();
    shapes.points.push_back(moved_points(points, any_similarity(random, keep_size)));
  }
  return shapes;
}

Point mean_place(const std::vector<Point>& points) {
  Point sum = Point::Zero();
  for (const Point& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

double centroid_size(const std::vector<Point>& points) {
  const Point centroid = mean_place(points);
  double sum = 0;
  for (const Point& point : points) sum += (point - centroid).squaredNorm();
  return std::sqrt(sum);
}

std::string refusal(const CorrespondingPoints& shapes) {
  try {
    shape_model(shapes);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "nothing refused";
}

TEST(ShapeModel, SimilarCopiesDoNotVary) {
  test::Random random(1);
  const std::vector<Point> shape = test::rough_sphere(1, 0.3, 1).vertices;
  CorrespondingPoints shapes;
  double mean_size = 0;
  for (int i = 0; i < 5; ++i) {
    shapes.points.push_back(moved_points(shape, any_similarity(random)));
    mean_size += centroid_size(shapes.points.back()) / 5;
  }
  const ShapeModel model = shape_model(shapes);
  EXPECT_EQ(model.modes.rows(), 0);
  EXPECT_EQ(model.variances.size(), 0);
  EXPECT_NEAR(centroid_size(model.mean), mean_size, 1e-12 * mean_size);
  EXPECT_LT(mean_place(model.mean).norm(), 1e-12 * mean_size);
  const ModelQuality quality = model_quality(model);
  EXPECT_TRUE(quality.compactness.empty());
}

TEST(ShapeModel, SizeIsAMode) {
  const std::vector<Point> shape = test::icosphere(1).vertices;
  const CorrespondingPoints shapes =
      of({shape, moved_points(shape, {2, Eigen::Matrix3d::Identity(), Point(1, 2, 3)})});
  const ShapeModel model = shape_model(shapes, {.keep_size = true});
  ASSERT_EQ(model.modes.rows(), 1);
  // Unit spheres of 42 points: radii 1 and 2.
  EXPECT_NEAR(centroid_size(model.mean), 1.5 * std::sqrt(42.0), 1e-9);
  EXPECT_NEAR(model.variances[0], 0.5 * 42, 1e-9);
}

TEST(ShapeModel, OneModeOfKnownVarianceIsFound) {
  const std::vector<double> heights = {1, 1.5, 2.5};
  CorrespondingPoints shapes;
  test::Random random(3);
  for (const double height : heights)
    shapes.points.push_back(moved_points(stretched(height), any_similarity(random, true)));
  const ShapeModel model = shape_model(shapes, {.keep_size = true});
  ASSERT_EQ(model.modes.rows(), 1);
  double square = 0;
  for (const Point& point : stretched(1)) square += point.z() * point.z();
  // Mean 5/3, deviations -2/3, -1/6, 5/6.
  const double variance = (4.0 / 9 + 1.0 / 36 + 25.0 / 36) / 2;
  EXPECT_NEAR(model.variances[0], variance * square, 1e-9);
  const double sign = model.scores(2, 0) > 0 ? 1 : -1;
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(sign * model.scores(i, 0), (heights[i] - 5.0 / 3) * std::sqrt(square), 1e-9);
  const std::vector<Point> third =
      model.shape_at({model.scores(2, 0) / std::sqrt(variance * square)});
  for (std::size_t p = 0; p < third.size(); ++p)
    EXPECT_LT((third[p] - model.alignments[2].apply(shapes.points[2][p])).norm(), 1e-9);
  EXPECT_THROW(model.shape_at({1, 2}), InvalidInput);
}

TEST(ShapeModel, IsMadeOfItsParts) {
  const CorrespondingPoints shapes = family(6, 3, 0.02, 4);
  const ShapeModel model = shape_model(shapes);
  const Eigen::Index count = model.modes.rows();
  ASSERT_EQ(count, 5);
  EXPECT_LT(
      (model.modes * model.modes.transpose() - Eigen::MatrixXd::Identity(count, count)).norm(),
      1e-9);
  const Eigen::Map<const Eigen::RowVectorXd> mean(model.mean.front().data(),
                                                  3 * std::ssize(model.mean));
  const Eigen::MatrixXd again = (model.scores * model.modes).rowwise() + mean;
  EXPECT_LT((again - model.aligned).norm(), 1e-9);
  for (Eigen::Index k = 0; k < count; ++k) {
    EXPECT_NEAR(model.scores.col(k).squaredNorm() / 5, model.variances[k], 1e-12);
    EXPECT_GT(model.modes.row(k).maxCoeff(), (1 - 1e-6) * -model.modes.row(k).minCoeff());
    EXPECT_GE(model.variances[std::max<Eigen::Index>(k - 1, 0)], model.variances[k]);
  }
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(model.alignments[i].rotation.determinant(), 1, 1e-12);
    for (std::size_t p = 0; p < model.mean.size(); ++p)
      EXPECT_LT((model.alignments[i].apply(shapes.points[i][p]) -
                 model.aligned.row(i).segment<3>(static_cast<Eigen::Index>(3 * p)).transpose())
                    .norm(),
                1e-12 * centroid_size(model.mean) * 10);
  }
}

TEST(ShapeModel, HasAsManyModesAsAskedForAndPossible) {
  const CorrespondingPoints shapes = family(6, 3, 0.02, 4);
  const ShapeModel all = shape_model(shapes), two = shape_model(shapes, {.modes = 2});
  EXPECT_EQ(two.modes.rows(), 2);
  EXPECT_EQ(two.scores, all.scores.leftCols(2));
  EXPECT_EQ(shape_model(shapes, {.modes = 100}).modes.rows(), 5);
  EXPECT_LT(model_quality(two).compactness.back(), 1);
  EXPECT_NEAR(model_quality(two).generalisation.back(), model_quality(all).generalisation[1],
              1e-12);
}

TEST(ShapeModel, MoreShapesThanCoordinatesHaveFewerModes) {
  test::Random random(5);
  CorrespondingPoints shapes;
  for (int i = 0; i < 30; ++i) {
    std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (Point& point : points) point += 0.1 * random.direction();
    shapes.points.push_back(points);
  }
  const ShapeModel model = shape_model(shapes, {.keep_size = true});
  // Of 12 coordinates, 6 are the place; what turning does to the rest is of second order.
  EXPECT_GE(model.modes.rows(), 6);
  EXPECT_LE(model.modes.rows(), 9);
  EXPECT_LT((model.modes * model.modes.transpose()).isIdentity(1e-6) ? 0 : 1, 1);
}

TEST(ShapeModel, WhereShapesLieAndHowLargeTheyAreDoesNotMatter) {
  const CorrespondingPoints shapes = family(6, 3, 0.05, 6, true);
  CorrespondingPoints others = shapes;
  test::Random random(7);
  for (std::size_t i = 0; i < 6; ++i)
    others.points[i] =
        moved_points(shapes.points[i], {2, random.rotation(), 3 * random.direction()});
  const ShapeModel model = shape_model(shapes), other = shape_model(others);
  ASSERT_EQ(model.modes.rows(), other.modes.rows());
  EXPECT_LT((4 * model.variances - other.variances).norm(), 1e-8);
  EXPECT_LT((2 * model.scores.cwiseAbs() - other.scores.cwiseAbs()).norm(), 1e-7);
  const ModelQuality quality = model_quality(model), again = model_quality(other);
  for (std::size_t k = 0; k < quality.compactness.size(); ++k) {
    EXPECT_NEAR(quality.compactness[k], again.compactness[k], 1e-9);
    EXPECT_NEAR(2 * quality.generalisation[k], again.generalisation[k], 1e-8);
  }
}

TEST(ShapeModel, AMissingPointIsPredicted) {
  CorrespondingPoints shapes;
  for (const double height : {1.0, 1.2, 1.5, 2.0, 2.5}) shapes.points.push_back(stretched(height));
  const Point truth = shapes.points[3][5];
  shapes.present.assign(5, std::vector<bool>(shapes.points[0].size(), true));
  shapes.present[3][5] = false;
  shapes.points[3][5] = {kNan, kNan, kNan};
  for (const bool keep_size : {true, false}) {
    const ShapeModel model = shape_model(shapes, {.keep_size = keep_size});
    // Scaled to one size, heights are a curved line, which a mode touches.
    EXPECT_LT((completed_points(shapes, model, 3)[5] - truth).norm(), keep_size ? 1e-5 : 0.02);
    EXPECT_TRUE(model.aligned.allFinite());
  }
}

TEST(ShapeModel, AMissingHalfIsPredicted) {
  CorrespondingPoints shapes = family(12, 2, 0, 8, true);
  const std::vector<Point> truth = shapes.points[4];
  const std::size_t num_points = truth.size();
  shapes.present.assign(12, std::vector<bool>(num_points, true));
  for (std::size_t p = 0; p < num_points; p += 2) shapes.present[4][p] = false;
  const ShapeModel model = shape_model(shapes, {.keep_size = true});
  const std::vector<Point> completed = completed_points(shapes, model, 4);
  double square = 0;
  for (std::size_t p = 0; p < num_points; ++p) square += (completed[p] - truth[p]).squaredNorm();
  // Turning shapes bends the two modes by some 1 % of the variation, which is 0.1.
  EXPECT_LT(std::sqrt(square / static_cast<double>(num_points)), 0.01);
  EXPECT_EQ(completed[1], truth[1]);
}

TEST(ShapeModel, PartsWithoutAWholeAreCompleted) {
  // Each shape lacks a quarter of the points, and each point a quarter of the shapes.
  constexpr int kNumShapes = 20;
  CorrespondingPoints shapes = family(kNumShapes, 2, 0.01, 9);
  const CorrespondingPoints truth = shapes;
  const std::size_t num_points = truth.points[0].size();
  shapes.present.assign(kNumShapes, std::vector<bool>(num_points, true));
  for (int i = 0; i < kNumShapes; ++i)
    for (std::size_t p = i % 4; p < num_points; p += 4) {
      shapes.present[i][p] = false;
      shapes.points[i][p].setConstant(kNan);
    }
  const ShapeModel model = shape_model(shapes);
  for (int i = 0; i < kNumShapes; ++i) {
    const std::vector<Point> completed = completed_points(shapes, model, i);
    // Points lie some 2 from the centroid, and vary by some 0.1 and the noise.
    const double unit = centroid_size(truth.points[i]) / std::sqrt(num_points) / 2;
    for (std::size_t p = 0; p < num_points; ++p)
      EXPECT_LT((completed[p] - truth.points[i][p]).norm(), 0.03 * unit);
  }
}

TEST(ShapeModel, OfTwoShapesOneGivesTheOtherWhatItLacks) {
  CorrespondingPoints shapes = family(2, 0, 0, 15, true);
  shapes.present.assign(2, std::vector<bool>(shapes.points[0].size(), true));
  for (int p = 0; p < 10; ++p) shapes.present[1][p] = false;
  const std::vector<Point> completed =
      completed_points(shapes, shape_model(shapes, {.keep_size = true}), 1);
  for (int p = 0; p < 10; ++p) EXPECT_LT((completed[p] - shapes.points[1][p]).norm(), 1e-4);
}

TEST(ShapeModel, IsTheSameEachTime) {
  CorrespondingPoints shapes = family(8, 3, 0.02, 10);
  shapes.present.assign(8, std::vector<bool>(shapes.points[0].size(), true));
  for (int p = 3; p < 12; ++p) shapes.present[2][p] = false;
  const ShapeModel a = shape_model(shapes), b = shape_model(shapes);
  EXPECT_EQ(a.aligned, b.aligned);
  EXPECT_EQ(model_quality(a).specificity, model_quality(b).specificity);
  EXPECT_NE(model_quality(a, 10, 0).specificity, model_quality(a, 10, 1).specificity);
}

TEST(ShapeModel, RefusesWhatCannotBeOne) {
  const CorrespondingPoints good = family(3, 1, 0, 11);
  const std::size_t num_points = good.points[0].size();
  CorrespondingPoints bad = of({good.points[0]});
  EXPECT_THAT(refusal(bad), HasSubstr("two shapes"));
  bad = of({{Point(0, 0, 0), Point(1, 0, 0)}, {Point(0, 0, 0), Point(1, 0, 0)}});
  EXPECT_THAT(refusal(bad), HasSubstr("three points"));
  bad = good;
  bad.points[1].pop_back();
  EXPECT_THAT(refusal(bad), HasSubstr("same number"));
  bad = good;
  bad.points[1][2].x() = kNan;
  EXPECT_THAT(refusal(bad), HasSubstr("point 2 of shape 1 is not finite"));
  bad = good;
  bad.points[2].assign(num_points, Point(1, 2, 3));
  EXPECT_THAT(refusal(bad), HasSubstr("at one place"));
  bad = good;
  bad.present.assign(2, std::vector<bool>(num_points, true));
  EXPECT_THAT(refusal(bad), HasSubstr("each or of none"));
  bad.present.assign(3, std::vector<bool>(num_points, true));
  for (auto& present : bad.present) present[4] = false;
  EXPECT_THAT(refusal(bad), HasSubstr("no shape has point 4"));
  bad.present[0].assign(num_points, false);
  EXPECT_THAT(refusal(bad), HasSubstr("shape 0 has fewer than three points"));
  bad.present.assign(3, std::vector<bool>(num_points, true));
  for (std::size_t p = 0; p < num_points; ++p) {
    bad.present[0][p] = bad.present[1][p] = p < 10;
    bad.present[2][p] = p >= 8;
  }
  EXPECT_THAT(refusal(bad), HasSubstr("in common"));
}

TEST(ModelQuality, CompactnessSumsToOne) {
  const ModelQuality quality = model_quality(shape_model(family(9, 4, 0.05, 12)));
  ASSERT_EQ(quality.compactness.size(), 8U);
  EXPECT_NEAR(quality.compactness.back(), 1, 1e-12);
  EXPECT_TRUE(std::ranges::is_sorted(quality.compactness));
}

/// Root mean square distance of shape `i` from the nearest of a model of the others.
double left_out_distance(const Eigen::MatrixXd& aligned, Eigen::Index i, Eigen::Index count) {
  Eigen::MatrixXd others(aligned.rows() - 1, aligned.cols());
  others << aligned.topRows(i), aligned.bottomRows(aligned.rows() - 1 - i);
  const Eigen::RowVectorXd mean = others.colwise().mean();
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(others.rowwise() - mean, Eigen::ComputeThinV);
  count = std::min(count, others.rows() - 1);
  const Eigen::MatrixXd modes = svd.matrixV().leftCols(count);
  const Eigen::RowVectorXd rest = aligned.row(i) - mean;
  return (rest - rest * modes * modes.transpose()).norm() /
         std::sqrt(static_cast<double>(aligned.cols()) / 3);
}

TEST(ModelQuality, GeneralisationIsThatOfBruteForce) {
  for (const double noise : {0.0, 0.05}) {
    const ShapeModel model = shape_model(family(9, 4, noise, 13));
    const std::vector<double> found = model_quality(model).generalisation;
    for (Eigen::Index m = 1; m <= model.modes.rows(); ++m) {
      double sum = 0;
      for (Eigen::Index i = 0; i < 9; ++i) sum += left_out_distance(model.aligned, i, m);
      EXPECT_NEAR(found[m - 1], sum / 9, 1e-6 * found[0]) << m;
    }
  }
}

TEST(ModelQuality, SpecificityIsThatOfBruteForce) {
  // Of one mode, samples are normally distributed along a line with two shapes at +-1 / sqrt(2)
  // standard deviations. E| |x| - 1 / sqrt(2) | = 0.4739 by numerical integration.
  const std::vector<Point> shape = test::icosphere(1).vertices;
  const ShapeModel model = shape_model(of({stretched(1), stretched(2)}), {.keep_size = true});
  const ModelQuality quality = model_quality(model, 100000);
  ASSERT_EQ(quality.specificity.size(), 1U);
  const double unit = std::sqrt(model.variances[0] / static_cast<double>(shape.size()));
  EXPECT_NEAR(quality.specificity[0] / unit, 0.4739, 0.005);
  EXPECT_THAT(quality.generalisation, Each(testing::IsNan()));
}

TEST(ModelQuality, NeedsSamples) {
  EXPECT_THROW(model_quality(shape_model(family(4, 2, 0, 14)), 0), InvalidInput);
}

}  // namespace
}  // namespace isomatch
