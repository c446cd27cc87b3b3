// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/group_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "io/npz.h"
#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
#include "results/json.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace isomatch::results {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr int kLacking = 1, kMissing = 4;

/// Three ellipsoids of 42 points; one lacks a point.
GroupOutput ellipsoids() {
  GroupOutput output;
  output.names = {"a, b", "K\xC3\xB6rper", "third \"3\""};
  const Mesh sphere = test::icosphere(1);
  for (const Point& factors : {Point(1, 1, 1), Point(1, 1, 1.3), Point(1, 1.2, 1.1)}) {
    std::vector<Point> points;
    for (const Point& point : sphere.vertices)
      points.emplace_back(factors.cwiseProduct(point) + Point(5, 0, 0));
    output.points.points.push_back(points);
  }
  const int num_points = sphere.num_vertices();
  output.points.present.assign(3, std::vector<bool>(num_points, true));
  output.points.present[kLacking][kMissing] = false;
  output.points.points[kLacking][kMissing].setConstant(kNan);
  for (int v = 0; v < num_points; ++v) output.template_vertices.push_back(v);
  output.faces = faces_between(sphere, output.template_vertices);
  output.model = shape_model(output.points);
  output.quality = model_quality(output.model, 10);
  output.columns = {{"fit", {"good", "bad, very", ""}}};
  return output;
}

class GroupFolder : public testing::Test {
 protected:
  void write() {
    ResultFolder folder(
        {.folder = folder_.path("out"), .files = group_files(output_.names), .inputs = {}});
    write_group(folder, output_);
    folder.write_report(Json::object());
  }

  std::string path(const std::string& name) const { return folder_.path("out/" + name); }
  std::string text(const std::string& name) const { return test::read_file(path(name)); }
  NpzArrays arrays(const std::string& name) const { return read_npz(InputFile(path(name))); }
  bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }

  std::vector<std::string> lines(const std::string& name) const {
    std::istringstream stream(text(name));
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  /// The numbers of a particle file.
  std::vector<Point> particles(const std::string& shape) const {
    std::istringstream stream(text("particles/" + shape + ".particles"));
    std::vector<Point> points;
    for (Point x; stream >> x[0] >> x[1] >> x[2];) points.push_back(x);
    return points;
  }

  GroupOutput output_ = ellipsoids();
  test::TemporaryFolder folder_;
};

TEST_F(GroupFolder, HasPointsAsArrays) {
  write();
  const NpzArrays read = arrays("points.npz");
  const NpyArray& points = read.at("points");
  EXPECT_THAT(points.shape, ElementsAre(3, 42, 3));
  for (std::size_t i = 0, k = 0; i < 3; ++i)
    for (const Point& point : output_.points.points[i])
      for (const double x : point) {
        if (std::isnan(x))
          EXPECT_TRUE(std::isnan(points.values[k++]));
        else
          EXPECT_EQ(points.values[k++], x);
      }
  EXPECT_THAT(read.at("template_faces").shape, ElementsAre(80, 3));
  EXPECT_EQ(read.at("template_faces").values[4], output_.faces[1][1]);
  EXPECT_EQ(read.at("template_vertices").values[7], 7);
}

TEST_F(GroupFolder, HasTheModelAsArrays) {
  write();
  const NpzArrays read = arrays("modes.npz");
  const ShapeModel& model = output_.model;
  EXPECT_THAT(read.at("mean").shape, ElementsAre(42, 3));
  EXPECT_EQ(read.at("mean").values[5], model.mean[1].z());
  EXPECT_THAT(read.at("modes").shape, ElementsAre(2, 42, 3));
  EXPECT_EQ(read.at("modes").values[3 * 42 + 10], model.modes(1, 10));
  EXPECT_THAT(read.at("aligned").shape, ElementsAre(3, 42, 3));
  EXPECT_EQ(read.at("aligned").values[2 * 3 * 42 + 6], model.aligned(2, 6));
  EXPECT_THAT(read.at("scores").shape, ElementsAre(3, 2));
  EXPECT_EQ(read.at("scores").values[3], model.scores(1, 1));
  EXPECT_EQ(read.at("variances").values[1], model.variances[1]);
  EXPECT_EQ(read.at("compactness").values, output_.quality.compactness);
  EXPECT_EQ(read.at("generalisation").values, output_.quality.generalisation);
  EXPECT_EQ(read.at("specificity").values, output_.quality.specificity);
  EXPECT_THAT(read.at("template_faces").shape, ElementsAre(80, 3));
}

TEST_F(GroupFolder, HasPointsAsATable) {
  write();
  const std::vector<std::string> table = lines("points.csv");
  ASSERT_EQ(table.size(), 1U + 3 * 42);
  EXPECT_EQ(table[0], "shape,point,x,y,z,present");
  EXPECT_THAT(table[1], StartsWith("\"a, b\",0,"));
  EXPECT_THAT(table[1], testing::EndsWith(",1"));
  EXPECT_EQ(table[1 + 42 + kMissing], "K\xC3\xB6rper,4,,,,0");
  EXPECT_THAT(table[1 + 2 * 42], StartsWith("\"third \"\"3\"\"\",0,"));
}

TEST_F(GroupFolder, HasScoresInStandardDeviations) {
  write();
  const std::vector<std::string> table = lines("scores.csv");
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[0], "shape,points,mode_1,mode_2,fit");
  const ShapeModel& model = output_.model;
  const std::string start = "K\xC3\xB6rper,41,";
  ASSERT_THAT(table[2], StartsWith(start));
  EXPECT_NEAR(std::stod(table[2].substr(start.size())),
              model.scores(1, 0) / std::sqrt(model.variances[0]), 1e-5);
  EXPECT_THAT(table[2], HasSubstr(",\"bad, very\""));
  EXPECT_THAT(table[3], testing::EndsWith(","));
}

TEST_F(GroupFolder, HasMeshesWithoutTheFacesOfMissingPoints) {
  write();
  const Mesh whole = read_mesh(path("meshes/a, b.ply"));
  EXPECT_EQ(whole.vertices, output_.points.points[0]);
  EXPECT_EQ(whole.faces, output_.faces);
  const Mesh part = read_mesh(path("meshes/K\xC3\xB6rper.ply"));
  EXPECT_EQ(part.vertices, completed_points(output_.points, output_.model, kLacking));
  // The vertices of an icosahedron have five faces.
  EXPECT_EQ(part.num_faces(), 75);
  EXPECT_EQ(read_mesh(path("mean.ply")).vertices, output_.model.mean);
  EXPECT_EQ(read_mesh(path("modes/mode_2_minus_2sd.ply")).vertices,
            output_.model.shape_at({0, -2}));
  EXPECT_EQ(read_mesh(path("modes/mode_1_plus_2sd.ply")).vertices, output_.model.shape_at({2}));
  EXPECT_FALSE(has("modes/mode_3_plus_2sd.ply"));
}

TEST_F(GroupFolder, HasParticlesOfAllPoints) {
  write();
  EXPECT_EQ(particles("a, b"), output_.points.points[0]);
  EXPECT_EQ(particles("K\xC3\xB6rper"), completed_points(output_.points, output_.model, kLacking));
}

TEST_F(GroupFolder, HasLandmarksThatMayBeMissing) {
  write();
  const Json json = Json::parse(text("landmarks/K\xC3\xB6rper.mrk.json"));
  EXPECT_THAT(json.at("@schema").get<std::string>(),
              testing::EndsWith("/markups-schema-v1.0.3.json#"));
  const Json& markup = json.at("markups").at(0);
  EXPECT_EQ(markup.at("type"), "Fiducial");
  EXPECT_EQ(markup.at("coordinateSystem"), "LPS");
  const Json& points = markup.at("controlPoints");
  ASSERT_EQ(points.size(), 42U);
  EXPECT_EQ(points[2].at("id"), "3");
  EXPECT_EQ(points[2].at("label"), "2");
  EXPECT_EQ(points[2].at("position").at(1), output_.points.points[kLacking][2].y());
  EXPECT_EQ(points[2].at("positionStatus"), "defined");
  EXPECT_EQ(points[kMissing].at("positionStatus"), "missing");
  EXPECT_FALSE(points[kMissing].contains("position"));
}

TEST_F(GroupFolder, WithoutFacesHasNoMeshes) {
  output_.faces.clear();
  write();
  EXPECT_FALSE(has("meshes"));
  EXPECT_FALSE(has("mean.ply"));
  EXPECT_FALSE(arrays("points.npz").contains("template_faces"));
  EXPECT_TRUE(has("particles/a, b.particles"));
}

TEST_F(GroupFolder, OfManyPointsHasNoLandmarks) {
  const Mesh sphere = test::icosphere(4);
  output_.points = {{sphere.vertices, sphere.vertices, test::rough_sphere(4, 0.1, 1).vertices}, {}};
  output_.template_vertices.resize(sphere.vertices.size());
  output_.model = shape_model(output_.points);
  write();
  EXPECT_FALSE(has("landmarks"));
}

TEST_F(GroupFolder, WritesNothingButWhatItPlans) {
  write();
  const std::vector<std::string> planned = group_files(output_.names);
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path(""))) {
    if (!entry.is_regular_file() || entry.path().filename() == kReport) continue;
    ++count;
    EXPECT_THAT(planned, testing::Contains(entry.path().lexically_relative(path("")).string()));
  }
  // All but six meshes of modes that there are not.
  EXPECT_EQ(count, std::ssize(planned) - 6);
}

TEST_F(GroupFolder, RefusesWhatDoesNotFit) {
  EXPECT_THROW(check_shape_names({"a", "b", "a"}), InvalidInput);
  EXPECT_THROW(check_shape_names({"a", ""}), InvalidInput);
  EXPECT_THROW(check_shape_names({"a", "b/c"}), InvalidInput);
  output_.template_vertices.pop_back();
  EXPECT_THROW(write(), InvalidInput);
  output_ = ellipsoids();
  output_.columns[0].values.pop_back();
  EXPECT_THROW(write(), InvalidInput);
}

TEST(FacesBetween, AreThoseOfChosenVertices) {
  const Mesh mesh{std::vector<Point>(4, Point::Zero()), {{0, 1, 2}, {1, 3, 2}}};
  EXPECT_THAT(faces_between(mesh, {3, 2, 1}), ElementsAre(Face{2, 0, 1}));
}

}  // namespace
}  // namespace isomatch::results
