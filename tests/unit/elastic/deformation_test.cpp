// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/deformation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include "support/random.h"
#include "support/shapes.h"

namespace isomatch::elastic {
namespace {

/// Weight of an edge in the energy, a cotangent of 60 degrees.
const double kEdgeWeight = 1 / std::sqrt(3.0);

/// The vertices that share an edge with each.
IndexLists edges_of(const Mesh& mesh) {
  std::vector<std::set<int>> neighbours(mesh.vertices.size());
  for (const Face& face : mesh.faces)
    for (int a : face)
      for (int b : face)
        if (a != b) neighbours[a].insert(b);
  std::vector<int> offsets{0}, values;
  for (const auto& list : neighbours) {
    values.insert(values.end(), list.begin(), list.end());
    offsets.push_back(static_cast<int>(values.size()));
  }
  return {std::move(offsets), std::move(values)};
}

Deformation deformation_of(const Mesh& mesh) { return {mesh.vertices, edges_of(mesh)}; }

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double largest_distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

std::vector<Goal> anchors_at(const std::vector<Point>& points, double weight) {
  std::vector<Goal> goals(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    goals[i].anchor = points[i];
    goals[i].anchor_weight = weight;
  }
  return goals;
}

struct RigidMotion {
  Eigen::Matrix3d rotation;
  Point shift;

  std::vector<Point> operator()(std::vector<Point> points) const {
    for (Point& p : points) p = rotation * p + shift;
    return points;
  }
};

class DeformationTest : public testing::TestWithParam<double> {
 protected:
  void fit(Deformation& deformation) const {
    for (int i = 0; i < 30; ++i) deformation.fit_rotations(GetParam(), {});
  }

  const Mesh mesh_ = test::rough_sphere(2, 0.2, 1);
};

TEST_P(DeformationTest, ReproducesARigidMotionOfAllGoals) {
  test::Random random(1);
  for (int trial = 0; trial < 5; ++trial) {
    const RigidMotion motion{random.rotation(), 3 * random.direction()};
    const std::vector<Point> moved = motion(mesh_.vertices);
    Deformation deformation = deformation_of(mesh_);
    deformation.set_positions(moved);
    fit(deformation);
    EXPECT_LT(total(deformation.energies()), 1e-9);
    deformation.fit_positions(anchors_at(moved, 0.01), 1);
    EXPECT_LT(largest_distance(deformation.positions(), moved), 1e-5);
    for (const Eigen::Quaterniond& rotation : deformation.rotations())
      EXPECT_LT((rotation.toRotationMatrix() - motion.rotation).norm(), 1e-4);
  }
}

TEST_P(DeformationTest, FindsARigidMotionFromTheRestPose) {
  test::Random random(2);
  const RigidMotion motion{random.rotation(), Point(1, 0, 0)};
  const std::vector<Point> moved = motion(mesh_.vertices);
  Deformation deformation = deformation_of(mesh_);
  for (int step = 0; step < 100; ++step) {
    deformation.fit_positions(anchors_at(moved, 1), 0.1);
    deformation.fit_rotations(GetParam(), {});
  }
  EXPECT_LT(largest_distance(deformation.positions(), moved), 1e-3);
  EXPECT_LT(total(deformation.energies()), 1e-5);
}

TEST_P(DeformationTest, EnergiesDoNotDependOnThePose) {
  test::Random random(3);
  std::vector<Point> bent = mesh_.vertices;
  for (Point& p : bent) p = Point(1.2 * p.x(), p.y() + 0.2 * p.x() * p.x(), 0.9 * p.z());
  Deformation plain = deformation_of(mesh_), moved = deformation_of(mesh_);
  plain.set_positions(bent);
  moved.set_positions(RigidMotion{random.rotation(), random.direction()}(bent));
  fit(plain);
  fit(moved);
  const std::vector<double> expected = plain.energies(), energies = moved.energies();
  EXPECT_GT(total(expected), 0.1);
  for (std::size_t i = 0; i < energies.size(); ++i) EXPECT_NEAR(energies[i], expected[i], 1e-4);
}

TEST_P(DeformationTest, StretchHasAKnownEnergy) {
  std::vector<Point> larger = mesh_.vertices;
  for (Point& p : larger) p *= 1.3;
  Deformation deformation = deformation_of(mesh_);
  deformation.set_positions(larger);
  fit(deformation);
  const std::vector<double> energies = deformation.energies();
  for (int i = 0; i < deformation.size(); ++i) {
    double expected = 0;
    for (int j : deformation.neighbours()[i])
      expected +=
          0.5 * kEdgeWeight * 0.3 * 0.3 * (mesh_.vertices[i] - mesh_.vertices[j]).squaredNorm();
    EXPECT_NEAR(energies[i], expected, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Smoothness, DeformationTest, testing::Values(0.0, 0.5),
                         [](const auto& test) { return test.param > 0 ? "Smooth" : "Plain"; });

/// What `fit_positions` minimises, at the present rotations.
double objective(Deformation& deformation, const std::vector<Goal>& goals, double stiffness,
                 std::vector<Point> positions) {
  deformation.set_positions(std::move(positions));
  double sum = stiffness * total(deformation.energies());
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const Goal& goal = goals[i];
    const Point& p = deformation.positions()[i];
    const double height = goal.normal.dot(p - goal.foot);
    sum += goal.weight * height * height + goal.anchor_weight * (p - goal.anchor).squaredNorm();
  }
  return sum;
}

TEST(Deformation, PositionsMinimiseEnergyAndDistances) {
  test::Random random(4);
  const Mesh mesh = test::icosphere(2);
  std::vector<Goal> goals(mesh.vertices.size());
  for (std::size_t i = 0; i < goals.size(); ++i)
    goals[i] = {1.5 * mesh.vertices[i] + 0.1 * random.direction(), random.direction(),
                random.uniform(), mesh.vertices[i] + 0.5 * random.direction(), random.uniform()};
  Deformation deformation = deformation_of(mesh);
  deformation.fit_positions(goals, 0.5);
  deformation.fit_rotations(0, {});
  // Of two calls the second begins where the first ended, so it has nothing left to do.
  for (int i = 0; i < 4; ++i) deformation.fit_positions(goals, 0.5);
  const std::vector<Point> best = deformation.positions();
  const double least = objective(deformation, goals, 0.5, best);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Point> other = best;
    for (Point& p : other) p += 0.01 * random.direction();
    EXPECT_GT(objective(deformation, goals, 0.5, other), least);
  }
}

TEST(Deformation, StiffnessResistsTheGoals) {
  const Mesh mesh = test::icosphere(1);
  std::vector<Point> pulled = mesh.vertices;
  pulled[0] *= 2;
  double energy = 0;
  for (const double stiffness : {10.0, 1.0, 0.1, 0.01}) {
    Deformation deformation = deformation_of(mesh);
    deformation.fit_positions(anchors_at(pulled, 1), stiffness);
    const double more = total(deformation.energies());
    EXPECT_GT(more, energy);
    energy = more;
  }
}

TEST(Deformation, GoalPlanesLetPointsSlide) {
  const Mesh mesh = test::sheet(5, 5);
  std::vector<Goal> goals(mesh.vertices.size());
  for (Goal& goal : goals) goal = {Point(7, -3, 2), Point::UnitZ(), 1, Point::Zero(), 0};
  // One weak anchor fixes what planes alone leave open.
  goals[0].anchor = Point(0, 0, 2);
  goals[0].anchor_weight = 1e-3;
  Deformation deformation = deformation_of(mesh);
  for (int i = 0; i < 5; ++i) deformation.fit_positions(goals, 1);
  std::vector<Point> raised = mesh.vertices;
  for (Point& p : raised) p.z() = 2;
  EXPECT_LT(largest_distance(deformation.positions(), raised), 1e-3);
}

TEST(Deformation, OfATriangleAndOfUnconnectedPoints) {
  const std::vector<Point> rest{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Point> goals{{5, 5, 5}, {5, 6, 5}, {4, 5, 5}};
  for (const IndexLists& neighbours :
       {IndexLists({0, 2, 4, 6}, {1, 2, 0, 2, 0, 1}), IndexLists({0, 0, 0, 0}, {})}) {
    Deformation deformation(rest, neighbours);
    for (int i = 0; i < 50; ++i) {
      deformation.fit_positions(anchors_at(goals, 1), 0.1);
      deformation.fit_rotations(0.5, {});
    }
    EXPECT_LT(largest_distance(deformation.positions(), goals), 1e-3);
  }
}

}  // namespace
}  // namespace isomatch::elastic
