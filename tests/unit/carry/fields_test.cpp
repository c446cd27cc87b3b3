// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isomatch/carry/transfer.h"
#include "isomatch/error.h"
#include "support/maps.h"
#include "support/random.h"
#include "support/shapes.h"

namespace isomatch {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

SurfaceMap random_map(const Mesh& onto, int size, test::Random& random) {
  SurfaceMap map;
  for (int i = 0; i < size; ++i) {
    const double a = random.uniform(), b = (1 - a) * random.uniform();
    map.push_back({random.index(onto.num_faces()), {a, b, 1 - a - b}});
  }
  return map;
}

TEST(TransferValues, CarriesLinearFunctionsExactly) {
  const Mesh source = test::icosphere(2);
  test::Random random(1);
  SurfaceMap map = random_map(source, 100, random);
  map[7] = {};
  Eigen::MatrixXd values(source.num_vertices(), 2);
  const auto function = [](const Point& p) {
    return Eigen::RowVector2d(1 + 2 * p.x() - 3 * p.y(), p.z());
  };
  for (int v = 0; v < source.num_vertices(); ++v) values.row(v) = function(source.vertices[v]);
  const Eigen::MatrixXd carried = transfer_values(source, map, values);
  ASSERT_EQ(carried.rows(), 100);
  for (int t = 0; t < 100; ++t) {
    if (t == 7)
      EXPECT_TRUE(carried.row(t).array().isNaN().all());
    else
      EXPECT_LT((carried.row(t) - function(position(source, map[t]))).norm(), 1e-12);
  }
}

TEST(TransferValues, AnUnknownValueOfNoWeightPlaysNoPart) {
  const Mesh source = test::sheet(1, 1);
  Eigen::MatrixXd values = Eigen::MatrixXd::Constant(4, 1, 5);
  values(source.faces[0][1]) = std::nan("");
  EXPECT_EQ(transfer_values(source, {{0, {0.5, 0, 0.5}}}, values)(0), 5);
  EXPECT_TRUE(std::isnan(transfer_values(source, {{0, {0.5, 0.5, 0}}}, values)(0)));
}

TEST(TransferLabels, VoteAndAreNeverMixed) {
  const Mesh source{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const SurfaceMap map{
      {0, {0.5, 0.3, 0.2}}, {0, {0.4, 0.3, 0.3}}, {0, {0.5, 0.5, 0}}, {0, {0, 0, 1}}, {}};
  EXPECT_THAT(transfer_labels(source, map, std::vector{9, 3, 3}),
              ElementsAre(3, 3, 3, 3, kNoLabel));
  EXPECT_THAT(transfer_labels(source, map, std::vector{9, 3, kNoLabel}),
              ElementsAre(9, 9, 3, kNoLabel, kNoLabel));
}

TEST(TransferLabels, OnlyLabelsOfTheSourceOccur) {
  const Mesh source = test::icosphere(2);
  test::Random random(2);
  std::vector<int> labels;
  for (int v = 0; v < source.num_vertices(); ++v) labels.push_back(v % 2 == 0 ? 10 : 1000);
  for (int label : transfer_labels(source, random_map(source, 500, random), labels))
    EXPECT_TRUE(label == 10 || label == 1000);
}

TEST(TransferSkin, WeightsSumToOneAndKeepTheirNumber) {
  const Mesh source = test::icosphere(2);
  test::Random random(3);
  SkinWeights weights(source.vertices.size());
  for (auto& influences : weights) {
    const double share = random.uniform();
    influences = {{random.index(5), share}, {5 + random.index(5), 1 - share}};
  }
  SurfaceMap map = random_map(source, 200, random);
  map[0] = {};
  const SkinWeights carried = transfer_skin(source, map, weights);
  EXPECT_THAT(carried[0], IsEmpty());
  for (std::size_t t = 1; t < carried.size(); ++t) {
    ASSERT_LE(carried[t].size(), 2U);
    double sum = 0;
    for (const Influence& influence : carried[t]) sum += influence.weight;
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_TRUE(std::ranges::is_sorted(carried[t], {}, &Influence::bone));
  }
}

TEST(TransferSkin, KeepsTheLargest) {
  const Mesh source{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const SkinWeights weights{{{4, 1}}, {{2, 1}}, {{4, 0.5}, {3, 0.5}}};
  EXPECT_THAT(transfer_skin(source, {{0, {0.25, 0.25, 0.5}}}, weights)[0],
              ElementsAre(Influence{2, 1.0 / 3}, Influence{4, 2.0 / 3}));
  EXPECT_THAT(transfer_skin(source, {{0, {1, 0, 0}}}, weights)[0], ElementsAre(Influence{4, 1}));
}

TEST(TransferPoints, OfVerticesAreTheirImages) {
  const Mesh mesh = test::icosphere(2);
  test::Random random(4);
  SurfaceMap map = random_map(mesh, mesh.num_vertices(), random);
  map[5] = {};
  EXPECT_EQ(transfer_points(mesh, mesh, map, test::identity_map(mesh)), map);
}

TEST(TransferPoints, BetweenVerticesLieBetweenTheirImages) {
  const Mesh source = test::sheet(1, 1), target = test::sheet(20, 20);
  SurfaceMap map;
  for (const Point& corner : source.vertices) {
    const auto vertex = std::ranges::find(target.vertices, corner) - target.vertices.begin();
    map.push_back(test::identity_map(target)[vertex]);
  }
  const SurfacePoint middle{1, {0.2, 0.5, 0.3}};
  const SurfaceMap carried = transfer_points(source, target, map, std::vector{middle});
  EXPECT_LT((position(target, carried[0]) - position(source, middle)).norm(), 1e-12);
}

TEST(Transfer, BadInputThrows) {
  const Mesh mesh = test::icosphere(1);
  const SurfaceMap map = test::identity_map(mesh);
  const std::vector<int> labels(mesh.vertices.size() - 1);
  EXPECT_THROW(transfer_labels(mesh, map, labels), InvalidInput);
  EXPECT_THROW(transfer_values(mesh, map, Eigen::MatrixXd(3, 1)), InvalidInput);
  EXPECT_THROW(transfer_values(mesh, {{mesh.num_faces(), {1, 0, 0}}},
                               Eigen::MatrixXd::Zero(mesh.num_vertices(), 1)),
               InvalidInput);
  SkinWeights weights(mesh.vertices.size());
  weights[3] = {{1, -0.5}};
  EXPECT_THROW(transfer_skin(mesh, map, weights), InvalidInput);
  weights[3] = {{1, 0.5}, {1, 0.5}};
  EXPECT_THROW(transfer_skin(mesh, map, weights), InvalidInput);
  EXPECT_THROW(transfer_points(mesh, mesh, SurfaceMap(3), map), InvalidInput);
}

}  // namespace
}  // namespace isomatch
