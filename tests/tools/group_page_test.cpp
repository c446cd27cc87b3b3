// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/group_page.h"

#include <gtest/gtest.h>

#include <cmath>

#include "isomatch/error.h"
#include "tools/packed_arrays.h"
#include "tools/sample_collection.h"

namespace isomatch::results {
namespace {

constexpr int kShapes = 6;
constexpr int kVertices = 1000;

const GroupPageData& data() {
  static const GroupPageData sample = sample_collection(kShapes, kVertices);
  return sample;
}

const PageData& page() {
  static const PageData packed = group_page_data(data());
  return packed;
}

std::vector<Point> points(const PageData& page, const std::string& name, const Json& box) {
  const std::vector<std::uint32_t> steps = unpacked(page, name);
  const std::size_t count = steps.size() / 3;
  std::vector<Point> decoded(count);
  for (int k = 0; k < 3; ++k)
    for (std::size_t p = 0; p < count; ++p)
      decoded[p][k] =
          box["low"][k].get<double>() + box["size"][k].get<double>() * steps[k * count + p] / 65535;
  return decoded;
}

TEST(GroupPage, PointsOfEachShapeComeBack) {
  const std::vector<std::uint32_t> numbers = unpacked(page(), "template/numbers");
  ASSERT_EQ(numbers.size(), data().template_mesh.vertices.size());
  for (const int member : {0, 2, 5}) {
    const std::string name = "members/" + std::to_string(member) + "/position";
    const std::vector<Point> decoded = points(page(), name, page().manifest["members"][member]);
    // Half a step in each direction of a shape some three units long.
    for (std::size_t p = 0; p < numbers.size(); ++p)
      ASSERT_LT((decoded[p] - data().members[member].points[numbers[p]]).norm(), 1e-4);
  }
}

TEST(GroupPage, SpreadComesBackAndTellsWhatIsMissing) {
  const std::vector<std::uint32_t> numbers = unpacked(page(), "template/numbers");
  const std::vector<std::uint32_t> steps = unpacked(page(), "members/1/spread");
  const double largest = page().manifest["spread_max"];
  int missing = 0;
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    const bool present = data().members[1].present[numbers[p]];
    ASSERT_EQ(steps[p] != 65535, present);
    if (present)
      ASSERT_NEAR(largest * steps[p] / 65534, data().members[1].spread[numbers[p]], largest * 1e-5);
    else
      ++missing;
  }
  EXPECT_GT(missing, 0);
  EXPECT_EQ(page().manifest["members"][1]["missing"], missing);
}

TEST(GroupPage, AModeMovesPointsByADeviation) {
  const ShapeModel& model = data().model->model;
  const std::vector<std::uint32_t> numbers = unpacked(page(), "template/numbers");
  const std::vector<Point> moves =
      points(page(), "model/modes/0", page().manifest["model"]["modes"][0]);
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    const Point expected =
        std::sqrt(model.variances[0]) * model.modes.row(0).segment<3>(3 * numbers[p]).transpose();
    ASSERT_LT((moves[p] - expected).norm(), 1e-4);
  }
}

TEST(GroupPage, AShapeThatLacksAPartIsShownAsLargeAsIfItWereWhole) {
  const double whole = page().manifest["members"][0]["area"];
  const double part = page().manifest["members"][1]["area"];
  EXPECT_NEAR(part, whole, 0.3 * whole);
}

TEST(GroupPage, NamesReasonsAndUsesAreThere) {
  const Json& poor = page().manifest["members"][2];
  EXPECT_EQ(poor["name"], "creature_2");
  EXPECT_EQ(poor["grade"], "poor");
  EXPECT_EQ(poor["reasons"][0], "two legs are exchanged");
  EXPECT_EQ(page().manifest["pairs"][0]["use"], "agrees");
  EXPECT_EQ(page().manifest["pairs"].size(), data().pairs.size());
}

TEST(GroupPage, CollectionsWithoutAModelOrSpreadHaveAPage) {
  GroupPageData bare = data();
  bare.model.reset();
  for (GroupPageMember& member : bare.members) member.spread.clear();
  const PageData bare_page = group_page_data(bare);
  EXPECT_TRUE(bare_page.manifest["model"].is_null());
  EXPECT_TRUE(bare_page.manifest["spread_max"].is_null());
}

TEST(GroupPage, LargeTemplatesAreSimplified) {
  GroupPageData large = sample_collection(5, 2 * kMaxGroupVertices);
  large.model.reset();
  const Json manifest = group_page_data(large).manifest;
  EXPECT_EQ(manifest["template"]["simplified"], true);
  EXPECT_LT(manifest["template"]["vertices"], 1.1 * kMaxGroupVertices);
}

TEST(GroupPage, WhatDoesNotFitIsRefused) {
  const auto refused = [&](auto change) {
    GroupPageData wrong = data();
    change(wrong);
    EXPECT_THROW(group_page_data(wrong), InvalidInput);
  };
  refused([](GroupPageData& d) { d.members.clear(); });
  refused([](GroupPageData& d) { d.template_shape = kShapes; });
  refused([](GroupPageData& d) { d.pairs.front().target = -1; });
  refused([](GroupPageData& d) { d.members[1].cycle_error = std::nan(""); });
  refused([](GroupPageData& d) { d.members[1].points.pop_back(); });
  refused([](GroupPageData& d) { d.members[3].points[0].x() = std::nan(""); });
  refused([](GroupPageData& d) { d.members[3].spread[0] = -1; });
  refused([](GroupPageData& d) { d.model->model.mean.pop_back(); });
}

}  // namespace
}  // namespace isomatch::results
