// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/projection.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch::elastic {
namespace {

constexpr ProjectionWeights kWeights{.normal = 0.3, .relief = 0.2, .place = 0.1};

std::vector<Point> vertex_normals(const Mesh& mesh) {
  std::vector<Point> normals(mesh.vertices.size(), Point::Zero());
  for (const auto& [a, b, c] : mesh.faces) {
    const Point& p = mesh.vertices[a];
    const Point normal = (mesh.vertices[b] - p).cross(mesh.vertices[c] - p);
    for (int v : {a, b, c}) normals[v] += normal;
  }
  for (Point& normal : normals) normal.normalize();
  return normals;
}

/// A point with all that tells it apart.
struct Query {
  Point position, normal;
  Features features;
};

Features random_features(test::Random& random) {
  Features features;
  for (double& value : features.relief) value = random.uniform(-1, 1);
  for (double& value : features.place) value = random.uniform();
  return features;
}

/// A mesh with what its projection refers to.
class Target {
 public:
  explicit Target(Mesh input, const ProjectionWeights& counted = kWeights)
      : mesh(std::move(input)),
        faces(vertex_faces(mesh)),
        normals(vertex_normals(mesh)),
        features(mesh.vertices.size()),
        weights(counted) {}
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  Projection projection() const { return {mesh, faces, normals, features, weights}; }

  Query vertex(int v) const { return {mesh.vertices[v], normals[v], features[v]}; }

  /// The square of what counts as the distance from a vertex.
  double squared_distance(const Query& query, int v) const {
    const auto square = [](double value) { return value * value; };
    double sum = (mesh.vertices[v] - query.position).squaredNorm() +
                 square(weights.normal) * (normals[v] - query.normal).squaredNorm();
    for (std::size_t k = 0; k < query.features.relief.size(); ++k)
      sum += square(weights.relief * (features[v].relief[k] - query.features.relief[k]));
    for (std::size_t k = 0; k < query.features.place.size(); ++k)
      sum += square(weights.place * (features[v].place[k] - query.features.place[k]));
    return sum;
  }

  Mesh mesh;
  IndexLists faces;
  std::vector<Point> normals;
  std::vector<Features> features;
  ProjectionWeights weights;
};

int plain_nearest_vertex(const Target& target, const Query& query) {
  int nearest = 0;
  for (int v = 1; v < target.mesh.num_vertices(); ++v)
    if (target.squared_distance(query, v) < target.squared_distance(query, nearest)) nearest = v;
  return nearest;
}

int nearest_vertex(const Target& target, const Query& query) {
  const NearestPoint nearest(target.mesh.vertices, target.normals, target.features, target.weights);
  return nearest(query.position, query.normal, query.features);
}

Foot foot(const Projection& projection, const Query& query) {
  return projection(query.position, query.normal, query.features);
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

double distance_to_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  double least = std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
  Eigen::Matrix<double, 3, 2> edges;
  edges << b - a, c - a;
  const Eigen::Vector2d st = edges.colPivHouseholderQr().solve(p - a);
  if (st.minCoeff() >= 0 && st.sum() <= 1) least = std::min(least, (p - a - edges * st).norm());
  return least;
}

double distance_to_faces(const Target& target, int vertex, const Point& position) {
  double least = std::numeric_limits<double>::max();
  for (int f : target.faces[vertex]) {
    const auto& [a, b, c] = target.mesh.faces[f];
    const auto& p = target.mesh.vertices;
    least = std::min(least, distance_to_triangle(position, p[a], p[b], p[c]));
  }
  return least;
}

/// That position and normal of `foot` are those of its weights.
void expect_consistent(const Target& target, const Foot& foot) {
  ASSERT_GE(foot.point.face, 0);
  ASSERT_LT(foot.point.face, target.mesh.num_faces());
  Point position = Point::Zero(), normal = Point::Zero();
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int corner = target.mesh.faces[foot.point.face][k];
    EXPECT_GE(foot.point.weights[k], -1e-12);
    sum += foot.point.weights[k];
    position += foot.point.weights[k] * target.mesh.vertices[corner];
    normal += foot.point.weights[k] * target.normals[corner];
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_LT((foot.position - position).norm(), 1e-12);
  EXPECT_LT((foot.normal - normal.normalized()).norm(), 1e-12);
}

TEST(Projection, IsThatOfBruteForce) {
  for (const auto& weights : {kWeights, ProjectionWeights{}, ProjectionWeights{0, 0, 0}}) {
    test::Random random(1);
    Target target(test::rough_sphere(2, 0.2, 1), weights);
    for (Features& features : target.features) features = random_features(random);
    const Projection projection = target.projection();
    for (int trial = 0; trial < 300; ++trial) {
      const Query query{random.uniform(0, 2) * random.direction(), random.direction(),
                        random_features(random)};
      const int vertex = nearest_vertex(target, query);
      EXPECT_EQ(vertex, plain_nearest_vertex(target, query));
      const Foot result = foot(projection, query);
      expect_consistent(target, result);
      EXPECT_NEAR((result.position - query.position).norm(),
                  distance_to_faces(target, vertex, query.position), 1e-12);
    }
  }
}

TEST(Projection, OfPointsOnTheSurfaceIsThemselves) {
  const Target target(test::rough_sphere(2, 0.1, 3));
  const Projection projection = target.projection();
  for (int v = 0; v < target.mesh.num_vertices(); ++v) {
    EXPECT_EQ(nearest_vertex(target, target.vertex(v)), v);
    const Foot result = foot(projection, target.vertex(v));
    expect_consistent(target, result);
    EXPECT_LT((result.position - target.mesh.vertices[v]).norm(), 1e-12);
    EXPECT_LT((result.normal - target.normals[v]).norm(), 1e-9);
  }
}

/// Two sheets .02 apart, the lower one facing down, as the skin of a thin limb.
Mesh thin_plate() {
  Mesh lower = test::sheet(10, 10), upper = lower;
  for (Face& face : lower.faces) std::swap(face[0], face[1]);
  for (Point& p : upper.vertices) p.z() = 0.02;
  return test::combined(lower, upper);
}

TEST(Projection, KeepsToTheSideOfTheNormal) {
  const Target target(thin_plate());
  const Projection projection = target.projection();
  const Point below(0.52, 0.47, -0.05);
  EXPECT_NEAR(foot(projection, {below, Point::UnitZ(), {}}).position.z(), 0.02, 1e-12);
  EXPECT_NEAR(foot(projection, {below, -Point::UnitZ(), {}}).position.z(), 0, 1e-12);
}

TEST(Projection, KeepsToThePlaceOnTheSurface) {
  Target target(thin_plate(), {.normal = 0, .relief = 0, .place = 0.1});
  for (int v = 0; v < target.mesh.num_vertices(); ++v)
    target.features[v].place.fill(target.mesh.vertices[v].z() > 0.01 ? 1 : 2);
  const Projection projection = target.projection();
  Features upper, lower;
  upper.place.fill(1);
  lower.place.fill(2);
  const Point between(0.52, 0.47, 0.01);
  EXPECT_NEAR(foot(projection, {between, Point::UnitZ(), upper}).position.z(), 0.02, 1e-12);
  EXPECT_NEAR(foot(projection, {between, Point::UnitZ(), lower}).position.z(), 0, 1e-12);
}

TEST(Projection, OntoDegenerateFacesIsAPoint) {
  const Target target(test::sphere_with_degenerate_faces());
  const Projection projection = target.projection();
  test::Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const Point position = random.uniform(0, 1.5) * random.direction();
    const Foot result = foot(projection, {position, position.normalized(), {}});
    EXPECT_TRUE(result.position.allFinite());
    EXPECT_GE(result.point.face, 0);
  }
}

TEST(Projection, OntoASingleTriangle) {
  const Target target({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const Projection projection = target.projection();
  const Foot inside = foot(projection, {{0.25, 0.25, 5}, Point::UnitZ(), {}});
  expect_consistent(target, inside);
  EXPECT_LT((inside.position - Point(0.25, 0.25, 0)).norm(), 1e-12);
  const Foot beyond = foot(projection, {{2, 2, 1}, Point::UnitZ(), {}});
  EXPECT_LT((beyond.position - Point(0.5, 0.5, 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace isomatch::elastic
