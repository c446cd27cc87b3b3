// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/synth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

#include "isomatch/error.h"
#include "isomatch/geodesics/geodesics.h"
#include "isomatch/shape/diagnosis.h"

namespace isomatch {
namespace {

Context with_threads(int threads) {
  Context context;
  context.threads = threads;
  return context;
}

SynthShape creature(int vertices, int pose, std::uint64_t seed) {
  return synthesize({"creature", vertices, pose, seed});
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.faces)
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  return sum;
}

double smallest_angle(const Mesh& mesh, const Face& face) {
  double least = 180;
  for (int i = 0; i < 3; ++i) {
    const Point& apex = mesh.vertices[face[i]];
    const Eigen::Vector3d u = mesh.vertices[face[(i + 1) % 3]] - apex;
    const Eigen::Vector3d v = mesh.vertices[face[(i + 2) % 3]] - apex;
    least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi);
  }
  return least;
}

/// Mean and minimum over the faces.
std::pair<double, double> smallest_angles(const Mesh& mesh) {
  double sum = 0, least = 180;
  for (const Face& face : mesh.faces) {
    const double angle = smallest_angle(mesh, face);
    sum += angle;
    least = std::min(least, angle);
  }
  return {sum / mesh.num_faces(), least};
}

class SynthMesh : public testing::TestWithParam<SynthOptions> {};

TEST_P(SynthMesh, IsAnEvenSphereOfTheWantedSize) {
  const Mesh mesh = synthesize(GetParam()).mesh;
  EXPECT_NEAR(mesh.num_vertices(), GetParam().vertices, 0.02 * GetParam().vertices);

  const MeshDiagnosis diagnosis = diagnose(mesh);
  EXPECT_TRUE(diagnosis.warnings().empty());
  EXPECT_EQ(diagnosis.given.components, 1);
  EXPECT_EQ(diagnosis.given.genus(), 0);
  EXPECT_GT(volume(mesh), 0);

  const auto [mean, least] = smallest_angles(mesh);
  // Measured over 160 meshes: means from 49, smallest from 14 at 1,000 vertices.
  EXPECT_GT(mean, 45);
  EXPECT_GT(least, 8);
}

INSTANTIATE_TEST_SUITE_P(
    Creatures, SynthMesh,
    testing::Values(SynthOptions{"creature", 1000, 0, 1}, SynthOptions{"creature", 1000, 3, 2},
                    SynthOptions{"creature", 1000, 4, 5}, SynthOptions{"creature", 5000, 1, 1},
                    SynthOptions{"creature", 5000, 2, 6}, SynthOptions{"creature", 5000, 7, 7},
                    SynthOptions{"creature", 50000, 1, 3}));

/// For each template point the vertex that the truth names, at rest.
std::vector<Point> named_places(const SynthShape& shape, const std::vector<int>& truth) {
  std::vector<Point> places;
  places.reserve(truth.size());
  for (int v : truth) places.push_back(shape.rest.at(v));
  return places;
}

double mean_edge(const SynthShape& shape) {
  return GeodesicGraph(shape.mesh, GeodesicOptions::edges()).mean_edge_length();
}

TEST(Synth, TruthsOfTwoPosesNameTheSamePlaces) {
  const SynthShape a = creature(5000, 1, 4), b = creature(2000, 2, 4);
  ASSERT_EQ(a.ground_truth.size(), kSynthTemplatePoints);
  ASSERT_EQ(b.ground_truth.size(), kSynthTemplatePoints);
  const auto places_a = named_places(a, a.ground_truth), places_b = named_places(b, b.ground_truth);
  double worst = 0;
  for (int i = 0; i < kSynthTemplatePoints; ++i)
    worst = std::max(worst, (places_a[i] - places_b[i]).norm());
  // No template point is further than about an edge from its vertex on either side.
  EXPECT_LT(worst, mean_edge(a) + mean_edge(b));
}

TEST(Synth, SymmetricTruthNamesTheMirroredPlaces) {
  const SynthShape shape = creature(3000, 5, 4);
  const auto places = named_places(shape, shape.ground_truth);
  const auto images = named_places(shape, shape.symmetric_ground_truth);
  double worst = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point mirrored(-places[i].x(), places[i].y(), places[i].z());
    worst = std::max(worst, (mirrored - images[i]).norm());
  }
  EXPECT_LT(worst, 2 * mean_edge(shape));
}

TEST(Synth, RestPoseIsItsOwnRest) {
  const SynthShape shape = creature(2000, 0, 9);
  EXPECT_EQ(shape.mesh.vertices, shape.rest);
}

TEST(Synth, PosesKeepGeodesicDistancesAndMoveTheBody) {
  const SynthShape a = creature(3000, 1, 1), b = creature(3000, 2, 1);
  std::vector<int> landmarks_a, landmarks_b;
  for (int i = 0; i < kSynthTemplatePoints; i += 100) {
    landmarks_a.push_back(a.ground_truth[i]);
    landmarks_b.push_back(b.ground_truth[i]);
  }
  const auto fields_a = geodesic_fields(GeodesicGraph(a.mesh), landmarks_a);
  const auto fields_b = geodesic_fields(GeodesicGraph(b.mesh), landmarks_b);
  const double largest = *std::max_element(fields_a.begin(), fields_a.end());
  double distortion = 0, moved = 0;
  const std::size_t m = landmarks_a.size();
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      const float ga = fields_a[i * a.mesh.num_vertices() + landmarks_a[j]];
      const float gb = fields_b[i * b.mesh.num_vertices() + landmarks_b[j]];
      distortion += std::abs(ga - gb) / largest / static_cast<double>(m * m);
      const auto chord = [&](const SynthShape& s, const std::vector<int>& l) {
        return (s.mesh.vertices[l[i]] - s.mesh.vertices[l[j]]).norm();
      };
      moved += std::abs(chord(a, landmarks_a) - chord(b, landmarks_b)) / largest /
               static_cast<double>(m * m);
    }
  }
  // Measured over seeds and poses: .007 to .013, of which .003 are the truth's vertex precision.
  EXPECT_LT(distortion, 0.016);
  EXPECT_GT(moved, distortion);
}

TEST(Synth, ThreadsChangeNothing) {
  const SynthOptions options{"creature", 3000, 3, 2};
  const SynthShape a = synthesize(options, with_threads(1));
  const SynthShape b = synthesize(options, with_threads(4));
  EXPECT_EQ(a.mesh.vertices, b.mesh.vertices);
  EXPECT_EQ(a.mesh.faces, b.mesh.faces);
  EXPECT_EQ(a.ground_truth, b.ground_truth);
  EXPECT_EQ(a.symmetric_ground_truth, b.symmetric_ground_truth);
}

TEST(Synth, PosesDifferInSizeAndShareNoVertex) {
  const SynthShape a = creature(2000, 1, 1), b = creature(2000, 2, 1);
  EXPECT_NE(a.mesh.num_vertices(), b.mesh.num_vertices());
  std::set<std::tuple<double, double, double>> places;
  for (const Point& p : a.rest) places.insert({p.x(), p.y(), p.z()});
  for (const Point& p : b.rest) EXPECT_FALSE(places.contains({p.x(), p.y(), p.z()}));
}

TEST(Synth, RejectsBadOptions) {
  EXPECT_THROW(synthesize({.shape = "teapot"}), InvalidInput);
  EXPECT_THROW(synthesize({.vertices = 10}), InvalidInput);
  EXPECT_THROW(synthesize({.vertices = 100'000'000}), InvalidInput);
  EXPECT_THROW(synthesize({.pose = -1}), InvalidInput);
}

}  // namespace
}  // namespace isomatch
