// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/map_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "isomatch/error.h"
#include "support/random.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

constexpr int kTargetVertices = 50, kTargetFaces = 90;
const MapChecks kChecks{300, kTargetVertices, kTargetFaces};

MapContent random_map() {
  test::Random random(9);
  MapContent map;
  for (int v = 0; v < *kChecks.source_vertices; ++v) {
    const double a = random.uniform(), b = random.uniform() * (1 - a);
    map.source_to_target.push_back(v % 7 == 3 ? kUnmatched : random.index(kTargetVertices));
    map.points.push_back(v % 7 == 3 ? SurfacePoint{}
                                    : SurfacePoint{random.index(kTargetFaces), {a, b, 1 - a - b}});
  }
  return map;
}

class MapFile : public testing::Test {
 protected:
  std::string error(const std::string& name, const std::string& content,
                    const MapChecks& checks = {}) const {
    try {
      read_map(folder_.write(name, content), checks);
    } catch (const BadFile& error) {
      EXPECT_THAT(error.what(), HasSubstr(name));
      return error.what();
    }
    return "no error";
  }

  VertexMap vertices(const std::string& name, const std::string& content,
                     const MapChecks& checks = {}) {
    return read_map(folder_.write(name, content), checks, std::nullopt, &report_).source_to_target;
  }

  TemporaryFolder folder_;
  MapReadReport report_;
};

TEST_F(MapFile, RoundTripsAreExact) {
  const MapContent map = random_map();
  for (const Numbering numbering : {Numbering::kFromZero, Numbering::kFromOne}) {
    for (const char* name : {"a.txt", "a.map", "a.npz", "A.NPZ"}) {
      write_map(folder_.path(name), map, numbering);
      const MapContent copy = read_map(folder_.path(name), kChecks, numbering);
      EXPECT_EQ(copy.source_to_target, map.source_to_target) << name;
    }
    for (const char* name : {"a.bary.txt", "a.npz"}) {
      write_map(folder_.path(name), map, numbering);
      EXPECT_EQ(read_map(folder_.path(name), kChecks, numbering).points, map.points) << name;
    }
  }
  MapContent full = map;
  for (int& vertex : full.source_to_target) vertex = std::max(vertex, 0);
  write_map(folder_.path("a.vts"), full);
  EXPECT_EQ(read_map(folder_.path("a.vts"), kChecks).source_to_target, full.source_to_target);
}

TEST_F(MapFile, NumberingIsDetectedOnlyWhereItMustBe) {
  const MapChecks three{std::nullopt, 3, std::nullopt};
  EXPECT_EQ(vertices("a.txt", "1\n3\n", three), (VertexMap{0, 2}));
  EXPECT_EQ(report_.numbering, Numbering::kFromOne);
  EXPECT_FALSE(report_.is_assumed);
  EXPECT_EQ(vertices("a.txt", "0\n3\n", three), (VertexMap{kUnmatched, 2}));
  EXPECT_EQ(vertices("a.map", "1\n2\n", three), (VertexMap{1, 2}));
  EXPECT_EQ(report_.numbering, Numbering::kFromZero);
  EXPECT_TRUE(report_.is_assumed);
  EXPECT_EQ(vertices("a.map", "1\n3\n"), (VertexMap{1, 3}));
  EXPECT_TRUE(report_.is_assumed);
  EXPECT_EQ(vertices("a.map", "0\n2\n", three), (VertexMap{0, 2}));
  EXPECT_FALSE(report_.is_assumed);
  EXPECT_THAT(error("a.txt", "-1\n3\n", three), HasSubstr("line 2: vertex 3 is out of range"));
  EXPECT_EQ(vertices("a.vts", "1\n2\n", three), (VertexMap{0, 1}));
  EXPECT_EQ(vertices("a.vts", "1\n0\n", three), (VertexMap{0, kUnmatched}));
  EXPECT_EQ(report_.numbering, Numbering::kFromOne);
}

TEST_F(MapFile, WhatNumpyWritesIsRead) {
  const MapChecks two{2, 3, 1};
  EXPECT_EQ(
      vertices("a.txt", "# from numpy\n# -1: none\n2.000000000000000000e+00\n-1.0e+00\n", two),
      (VertexMap{2, kUnmatched}));
  EXPECT_EQ(vertices("a.vts", "1.000000000000000000e+00\n3.0 # last\n", two), (VertexMap{0, 2}));
  EXPECT_EQ(read_map(folder_.write("a.bary.txt", "# t a b c\n0.0e+00 1 0 0\n-1. 0 0 0\n"), two)
                .points.size(),
            2U);
  EXPECT_THAT(error("a.txt", "1.5e+00\n"),
              HasSubstr("line 1: expected an integer, found '1.5e+00'"));
  EXPECT_THAT(error("a.txt", "nan\n"), HasSubstr("expected an integer"));
  EXPECT_THAT(error("a.txt", "1e300\n"), HasSubstr("line 1: expected an integer"));
}

TEST_F(MapFile, PairsAreReadByTheSameRules) {
  const MapChecks four_and_three{4, 3, std::nullopt};
  const auto pairs = [&](const std::string& content) {
    return read_matches(folder_.write("a.txt", content), four_and_three, std::nullopt, &report_)
        .matches;
  };
  EXPECT_EQ(pairs("0 2\n3.0 1.0e+00 0.25\n0 2\n"), (Correspondence{{0, 2}, {3, 1}}));
  EXPECT_FALSE(report_.is_assumed);
  EXPECT_EQ(pairs("4 1\n1 2\n"), (Correspondence{{0, 1}, {3, 0}}));
  EXPECT_EQ(report_.numbering, Numbering::kFromOne);
  EXPECT_EQ(pairs("1 3\n"), (Correspondence{{0, 2}}));
  EXPECT_EQ(pairs("1 2\n"), (Correspondence{{1, 2}}));
  EXPECT_TRUE(report_.is_assumed);
  EXPECT_THROW(pairs("0 3\n"), BadFile);
  EXPECT_THROW(pairs("1 2\n4 4\n"), BadFile);
  EXPECT_THROW(pairs("1 2\n2\n"), BadFile);
}

TEST_F(MapFile, GroundTruthHasAVertexForEveryPointOrNone) {
  EXPECT_EQ(read_ground_truth(folder_.write("a.vts", "1\n3\n1\n"), 3), (std::vector{0, 2, 0}));
  EXPECT_EQ(read_ground_truth(folder_.write("a.txt", "0\n2\n"), 3), (std::vector{0, 2}));
  EXPECT_THROW(read_ground_truth(folder_.write("a.vts", "4\n"), 3), BadFile);
  EXPECT_EQ(read_ground_truth(folder_.write("a.vts", "1\n0\n"), 3), (std::vector{0, -1}));
  EXPECT_EQ(read_ground_truth(folder_.write("a.txt", "0\n-1\n"), 3), (std::vector{0, -1}));
  EXPECT_THROW(read_ground_truth(folder_.write("a.vts", "-1\n"), 3), BadFile);
  EXPECT_THROW(read_ground_truth(folder_.write("a.bary.txt", "0 1 0 0\n"), 3), BadFile);
}

TEST_F(MapFile, BadTextIsRefused) {
  EXPECT_THAT(error("a.txt", "0\nx\n"), HasSubstr("line 2"));
  EXPECT_THAT(error("a.txt", "0 1\n"), HasSubstr("named .bary.txt"));
  EXPECT_THAT(error("a.txt", "\n\n"), HasSubstr("no vertices"));
  EXPECT_THAT(error("a.txt", ""), HasSubstr("empty"));
  EXPECT_THAT(error("a.txt", "-2\n"), HasSubstr("line 1"));
  EXPECT_THAT(error("a.txt", "99999999999\n"), HasSubstr("line 1"));
  EXPECT_THAT(error("a.vts", "-1\n"), HasSubstr("line 1"));
  EXPECT_THAT(error("a.txt", "0\n1\n", kChecks), HasSubstr("the source has 300"));
  EXPECT_THAT(error("a.bary.txt", "90 1 0 0\n", {1, 50, 90}), HasSubstr("face 90"));
  EXPECT_THAT(error("a.off", "0\n"), HasSubstr(".npz"));
}

TEST_F(MapFile, GroundTruthsKeepWhatIsUnmatched) {
  const std::vector<int> truth = {2, kUnmatched, 0};
  for (const std::string name : {"a.vts", "a.txt"}) {
    write_ground_truth(folder_.path(name), truth);
    EXPECT_EQ(read_ground_truth(folder_.path(name), 3), truth);
  }
  EXPECT_THROW(write_ground_truth(folder_.path("b.vts"), {}), InvalidInput);
}

TEST_F(MapFile, FormsThatAreNotThereCannotBeWritten) {
  MapContent map = random_map();
  EXPECT_THROW(write_map(folder_.path("a.vts"), map), InvalidInput);
  map.points.clear();
  EXPECT_THROW(write_map(folder_.path("a.bary.txt"), map), InvalidInput);
  EXPECT_THROW(write_map(folder_.path("a.npz"), {}), InvalidInput);
  EXPECT_THROW(write_map(folder_.path("a.off"), map), BadFile);
  EXPECT_TRUE(folder_.names().empty());
  write_map(folder_.path("a.npz"), map);
  EXPECT_TRUE(read_map(folder_.path("a.npz")).points.empty());
}

TEST_F(MapFile, SameMapSameBytes) {
  for (const char* name : {"a.npz", "b.npz"}) write_map(folder_.path(name), random_map());
  EXPECT_TRUE(test::read_file(folder_.path("a.npz")) == test::read_file(folder_.path("b.npz")));
}

TEST_F(MapFile, ArraysAreCheckedAgainstTheMeshes) {
  MapContent map = random_map();
  write_map(folder_.path("a.npz"), map);
  const auto error_with = [&](const MapChecks& checks) {
    try {
      read_map(folder_.path("a.npz"), checks);
    } catch (const BadFile& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(error_with({299, 50, 90}), HasSubstr("for 300 vertices"));
  EXPECT_THAT(error_with({300, 40, 90}), HasSubstr("vertex 4"));
  EXPECT_THAT(error_with({300, 50, 80}), HasSubstr("triangle 8"));
}

/// Reads whatever is in a file; anything but a map or a `BadFile` of one line fails.
bool accepts(const std::string& path) {
  try {
    const MapContent map = read_map(path);
    EXPECT_FALSE(map.source_to_target.empty() && map.points.empty());
    return true;
  } catch (const BadFile& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return false;
  }
}

TEST_F(MapFile, DamagedArraysAreRefusedOrValid) {
  const std::string path = folder_.path("a.npz");
  write_map(path, random_map());
  const std::string content = test::read_file(path);
  for (std::size_t size = 1; size < content.size(); size += 1 + size / 50)
    EXPECT_FALSE(accepts(folder_.write("b.npz", content.substr(0, size)))) << size;
  std::mt19937 random(5);
  int accepted = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string damaged = content;
    for (std::size_t change = 0; change <= random() % 3; ++change)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    accepted += accepts(folder_.write("b.npz", damaged));
  }
  // Checksums cover what matters, but not names and dates.
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, 2000);
}

}  // namespace
}  // namespace isomatch
