// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/values_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "isomatch/error.h"
#include "support/temporary_folder.h"

namespace isomatch {
namespace {

using testing::ElementsAre;
using testing::EndsWith;

template <class Read>
std::string error_of(const std::string& content, const Read& read) {
  const test::TemporaryFolder folder;
  try {
    read(folder.write("values.txt", content));
  } catch (const BadFile& error) {
    return error.what();
  }
  return "nothing was thrown";
}

std::string values_error(const std::string& content) {
  return error_of(content, [](const std::string& path) { read_values(path, 2); });
}

std::string skin_error(const std::string& content) {
  return error_of(content, [](const std::string& path) { read_skin_weights(path, 2); });
}

TEST(ValuesIo, WhatNumpyWritesIsRead) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("file.txt", "# labels\n3.000e+00\n-1.0e+00\n");
  EXPECT_THAT(read_labels(path, 2), ElementsAre(3, -1));
  EXPECT_EQ(read_values(path, 2)(0, 0), 3);
}

TEST(ValuesIo, WhatSpreadsheetsWriteIsRead) {
  const test::TemporaryFolder folder;
  Eigen::MatrixXd expected(2, 2);
  expected << 0.5, 2, -1, 4e3;
  for (const char* content : {"height,age\n0.5,2\n-1,4000\n", "0.5;2\n-1;4e3", ".5\t2\n-1\t4000\n"})
    EXPECT_EQ(read_values(folder.write("file.csv", content), 2), expected) << content;
  EXPECT_THAT(read_labels(folder.write("file.csv", "\"part\"\n3\n-1\n"), 2), ElementsAre(3, -1));
  EXPECT_THAT(values_error("0,5;2\n-1;4\n"), EndsWith("by ',' before, and by ';' here"));
  EXPECT_THAT(values_error("1,,2\n3,4,5\n"), EndsWith("but the column is empty"));
}

TEST(ValuesIo, CommaSeparatedFilesHaveCommas) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("file.CSV");
  Eigen::MatrixXd values(1, 2);
  values << 0.5, 2;
  write_values(path, values);
  EXPECT_EQ(test::read_file(path), "0.5,2\n");
  EXPECT_EQ(read_values(path, 1), values);
}

TEST(ValuesIo, RoundTripsAreExact) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path("file.txt");
  Eigen::MatrixXd values(2, 3);
  values << 1.0 / 3, -1e-300, 5, 0, 1e22, 0.1;
  write_values(path, values);
  EXPECT_EQ(read_values(path, 2), values);
  write_labels(path, {3, kNoLabel, 0});
  EXPECT_THAT(read_labels(path, 3), ElementsAre(3, kNoLabel, 0));
  const SkinWeights weights{{{0, 0.25}, {7, 0.75}}, {}, {{2, 1}}};
  write_skin_weights(path, weights);
  EXPECT_EQ(read_skin_weights(path, 3), weights);
}

TEST(ValuesIo, UnknownValuesStayUnknown) {
  const test::TemporaryFolder folder;
  const Eigen::MatrixXd values = read_values(folder.write("a.txt", "1 nan\n\nNaN 2\n"), 2);
  EXPECT_TRUE(std::isnan(values(0, 1)) && std::isnan(values(1, 0)));
  write_values(folder.path("b.txt"), values);
  EXPECT_EQ(test::read_file(folder.path("b.txt")), "1 nan\nnan 2\n");
}

TEST(ValuesIo, InfluencesAreSortedByBone) {
  const test::TemporaryFolder folder;
  const SkinWeights weights = read_skin_weights(folder.write("a.txt", "5:0.5 2:0.5\n"), 1);
  EXPECT_THAT(weights[0], ElementsAre(Influence{2, 0.5}, Influence{5, 0.5}));
}

TEST(ValuesIo, BadFilesAreNamedWithTheLine) {
  EXPECT_THAT(values_error("1\n"), EndsWith("has 1 lines, but the mesh has 2 vertices"));
  EXPECT_THAT(values_error("1\n2\n3\n"),
              EndsWith("line 3: more lines than the mesh has vertices, 2"));
  EXPECT_THAT(values_error("1 2\n3\n"), EndsWith("line 2: 1 values, but 2 on the first line"));
  EXPECT_THAT(values_error("1\nx\n"), EndsWith("line 2: expected a number, found 'x'"));
  EXPECT_THAT(error_of("-2\n1\n", [](const std::string& p) { read_labels(p, 2); }),
              EndsWith("line 1: label -2 is out of range"));
  EXPECT_THAT(skin_error("1:1\n1;2\n"), EndsWith("line 2: expected BONE:WEIGHT, found '1;2'"));
  EXPECT_THAT(skin_error("1:-1\n"),
              EndsWith("line 1: the weight in '1:-1' is not a number from 0"));
  EXPECT_THAT(skin_error("1:1 1:0\n"), EndsWith("line 1: a bone occurs twice"));
  EXPECT_THAT(skin_error("-1:1\n"), EndsWith("line 1: expected BONE:WEIGHT, found '-1:1'"));
}

}  // namespace
}  // namespace isomatch
