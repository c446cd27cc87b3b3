// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "isomatch/error.h"
#include "isomatch/io/map_io.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/measure/metrics.h"
#include "support/data.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

/// The orientation of the map that keeps vertex numbers.
MapOrientation orientation_between(const Mesh& source, const Mesh& target) {
  Correspondence matches;
  for (int v = 0; v < source.num_vertices(); ++v) matches.push_back({v, v});
  return map_orientation(Shape(source), Shape(target), matches);
}

Mesh inside_out(Mesh mesh) {
  for (Face& face : mesh.faces) std::swap(face[1], face[2]);
  return mesh;
}

std::vector<Mesh> orientable_meshes() {
  return {test::rough_sphere(3, 0.1, 1), test::torus(40, 20), test::box(8, Point(1, 2, 3)),
          test::sheet(20, 20), test::open_cylinder(30, 15)};
}

TEST(MapOrientation, IdentityPreserves) {
  for (const Mesh& mesh : orientable_meshes()) {
    const MapOrientation orientation = orientation_between(mesh, mesh);
    EXPECT_EQ(orientation.verdict, OrientationVerdict::kPreserves);
    EXPECT_EQ(orientation.preserved_share, 1);
    EXPECT_NEAR(orientation.mean_sign, 1, 1e-12);
  }
}

TEST(MapOrientation, MirroringReverses) {
  for (const Mesh& mesh : orientable_meshes()) {
    const MapOrientation orientation = orientation_between(mesh, test::mirrored(mesh));
    EXPECT_EQ(orientation.verdict, OrientationVerdict::kReverses);
    EXPECT_EQ(orientation.preserved_share, 0);
    EXPECT_NEAR(orientation.mean_sign, -1, 1e-12);
  }
}

TEST(MapOrientation, ScaleAndPositionDoNotMatter) {
  test::Random random(1);
  for (const Mesh& mesh : orientable_meshes()) {
    const Mesh other = test::scaled(test::moved(mesh, random), 5);
    EXPECT_EQ(orientation_between(mesh, other).verdict, OrientationVerdict::kPreserves);
    EXPECT_EQ(orientation_between(other, test::mirrored(mesh)).verdict,
              OrientationVerdict::kReverses);
  }
}

TEST(MapOrientation, ClosedMeshMayBeInsideOut) {
  const Mesh mesh = test::torus(40, 20);
  EXPECT_EQ(orientation_between(mesh, inside_out(mesh)).verdict, OrientationVerdict::kPreserves);
  EXPECT_EQ(orientation_between(test::mirrored(mesh), inside_out(mesh)).verdict,
            OrientationVerdict::kReverses);
}

TEST(MapOrientation, OpenSheetIsTakenAsItIsTurned) {
  const Mesh mesh = test::sheet(20, 20);
  EXPECT_EQ(orientation_between(mesh, inside_out(mesh)).verdict, OrientationVerdict::kReverses);
}

TEST(MapOrientation, FewTurnedFacesDoNotMatter) {
  const Mesh mesh = test::sphere_with_flipped_faces();
  EXPECT_EQ(orientation_between(mesh, mesh).verdict, OrientationVerdict::kPreserves);
  EXPECT_EQ(orientation_between(mesh, test::mirrored(mesh)).verdict, OrientationVerdict::kReverses);
}

TEST(MapOrientation, FacesTurnedAtRandomAreNotOriented) {
  test::Random random(2);
  const Mesh mesh = test::icosphere(3);
  Mesh turned = mesh;
  for (Face& face : turned.faces) {
    if (random.uniform() < 0.5) std::swap(face[1], face[2]);
  }
  EXPECT_EQ(orientation_between(mesh, turned).verdict, OrientationVerdict::kNotOriented);
  EXPECT_EQ(orientation_between(turned, mesh).verdict, OrientationVerdict::kNotOriented);
}

TEST(MapOrientation, MoebiusStripIsNotOriented) {
  const Mesh strip = test::moebius_strip(60);
  EXPECT_EQ(orientation_between(strip, strip).verdict, OrientationVerdict::kNotOriented);
}

TEST(MapOrientation, CollapsedMapIsUndecided) {
  const Shape shape(test::icosphere(3));
  Correspondence matches;
  for (int v = 0; v < shape.num_vertices(); ++v) matches.push_back({v, 0});
  const MapOrientation orientation = map_orientation(shape, shape, matches);
  EXPECT_EQ(orientation.verdict, OrientationVerdict::kUndecided);
  EXPECT_EQ(orientation.votes, 0);
}

TEST(MapOrientation, BadInputThrows) {
  const Shape shape(test::icosphere(1));
  EXPECT_THROW(map_orientation(shape, shape, {{0, 42}}), InvalidInput);
  EXPECT_THROW(map_orientation(shape, shape, {{0, 0}}, {.landmarks = 2}), InvalidInput);
  EXPECT_THROW(map_orientation(shape, shape, {{0, 0}}, {.min_distance = 0}), InvalidInput);
  EXPECT_THROW(map_orientation(shape, shape, {{0, 0}}, {.max_distance = 0.01}), InvalidInput);
}

struct ShapePair {
  std::string set, source, target;
};

std::ostream& operator<<(std::ostream& out, const ShapePair& pair) {
  return out << pair.set << " " << pair.source << " " << pair.target;
}

/// A known map between two meshes of an animal or a person, and the same flipped left to right.
class RealMapOrientation : public testing::TestWithParam<ShapePair> {
 protected:
  static std::string data(const std::string& path) { return test::data_path(path); }

  void SetUp() override {
    if (!std::filesystem::exists(data(GetParam().set)))
      GTEST_SKIP() << "no test data in " << data(GetParam().set);
    source_ = prepare(GetParam().source);
    target_ = prepare(GetParam().target);
    source_points_ = vts(source_, GetParam().source + ".vts");
  }

  static Shape prepare(const std::string& name) {
    return Shape(read_mesh(data(GetParam().set + "/" + name + ".off")));
  }

  static std::vector<int> vts(const Shape& shape, const std::string& name) {
    return read_vts(data(GetParam().set + "/corres/" + name), shape.num_vertices());
  }

  /// The map that takes each template point to its vertex in `target_vts`.
  Correspondence truth(const std::string& target_vts) const {
    const GroundTruth points =
        on_surfaces(source_, target_, {source_points_, vts(target_, target_vts)});
    VertexMap source_to_target(source_.num_vertices(), kUnmatched);
    for (int i = 0; i < points.size(); ++i) source_to_target[points.source[i]] = points.target[i];
    return to_correspondence(source_to_target);
  }

  Shape source_{test::icosphere(0)}, target_{test::icosphere(0)};
  std::vector<int> source_points_;
};

/// Every match to a random vertex within `radius`, relative to sqrt(area), of its target.
Correspondence blurred(const Correspondence& matches, const Shape& target, double radius) {
  test::Random random(3);
  const GeodesicGraph graph(target.mesh());
  GeodesicSearch search(graph);
  const auto limit = static_cast<float>(radius * std::sqrt(target.area()));
  Correspondence result;
  for (const auto& [s, t] : matches) {
    const auto near = search.ball(t, limit);
    result.push_back({s, near[random.index(static_cast<int>(near.size()))].vertex});
  }
  return result;
}

// Measured on these pairs: .92 to 1 of the landmarks are right.
TEST_P(RealMapOrientation, TruthPreservesAndSymmetricTruthReverses) {
  const auto right = map_orientation(source_, target_, truth(GetParam().target + ".vts"));
  EXPECT_EQ(right.verdict, OrientationVerdict::kPreserves);
  EXPECT_GT(right.preserved_share, 0.85);
  const auto flipped = map_orientation(source_, target_, truth(GetParam().target + ".sym.vts"));
  EXPECT_EQ(flipped.verdict, OrientationVerdict::kReverses);
  EXPECT_LT(flipped.preserved_share, 0.15);
}

// .15 sqrt(area) is ten edge lengths of these meshes; the mean error is about seven.
TEST_P(RealMapOrientation, VerdictsSurviveNoise) {
  const auto noisy = [&](const std::string& target_vts) {
    return map_orientation(source_, target_, blurred(truth(target_vts), target_, 0.15));
  };
  EXPECT_EQ(noisy(GetParam().target + ".vts").verdict, OrientationVerdict::kPreserves);
  EXPECT_EQ(noisy(GetParam().target + ".sym.vts").verdict, OrientationVerdict::kReverses);
}

INSTANTIATE_TEST_SUITE_P(Shapes, RealMapOrientation,
                         testing::Values(ShapePair{"tosca5k", "cat0", "cat5"},
                                         ShapePair{"tosca5k", "dog0", "dog7"},
                                         ShapePair{"tosca5k", "horse0", "horse6"},
                                         ShapePair{"tosca5k", "wolf0", "wolf1"},
                                         ShapePair{"tosca5k", "centaur0", "centaur3"},
                                         ShapePair{"faust5k", "tr_reg_008", "tr_reg_029"}));

}  // namespace
}  // namespace isomatch
