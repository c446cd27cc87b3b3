// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/paper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/synth.h"
#include "paper/saliency.h"
#include "paper/sampling.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"
#include "support/context.h"
#include "support/data.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

Mesh creature(int vertices, int pose, std::uint64_t seed) {
  return synthesize({"creature", vertices, pose, seed}).mesh;
}

std::set<int> sources_of(const Correspondence& matches) {
  std::set<int> sources;
  for (const Match& match : matches) sources.insert(match.source);
  return sources;
}

std::set<int> targets_of(const Correspondence& matches) {
  std::set<int> targets;
  for (const Match& match : matches) targets.insert(match.target);
  return targets;
}

/// 0 to count-1.
std::set<int> first_numbers(int count) {
  std::set<int> numbers;
  for (int i = 0; i < count; ++i) numbers.insert(numbers.end(), i);
  return numbers;
}

/// That every base of both shapes is matched on every level.
void expect_covering(const PaperResult& result) {
  for (const PaperLevel& level : result.levels) {
    EXPECT_EQ(sources_of(level.matches), first_numbers(level.source_bases));
    EXPECT_EQ(targets_of(level.matches), first_numbers(level.target_bases));
    EXPECT_TRUE(std::ranges::is_sorted(level.matches));
    EXPECT_EQ(std::ranges::adjacent_find(level.matches), level.matches.end());
    ASSERT_EQ(level.many_to_one.size(), level.source_bases);
    EXPECT_GE(std::ranges::min(level.many_to_one), 0);
    EXPECT_LT(std::ranges::max(level.many_to_one), level.target_bases);
  }
}

/// The lowest vertex of the mesh at each vertex of the surface.
std::set<int> lowest_copies(const Shape& shape) {
  std::set<int> lowest;
  for (int v = 0; v < shape.num_vertices(); ++v)
    if (shape.on_surface(v)) lowest.insert(shape.copies(v).front());
  return lowest;
}

void expect_every_vertex_once(const std::vector<int>& bases, const Shape& shape) {
  EXPECT_EQ(std::ssize(bases), shape.num_surface_vertices());
  EXPECT_EQ(std::set<int>(bases.begin(), bases.end()), lowest_copies(shape));
}

/// That all vertices have an image, copies at a seam the same, but those off the surface.
void expect_total(const VertexMap& map, const Shape& source, const Shape& target) {
  ASSERT_EQ(std::ssize(map), source.num_vertices());
  for (int v = 0; v < source.num_vertices(); ++v) {
    ASSERT_EQ(map[v] != kUnmatched, source.on_surface(v));
    if (map[v] == kUnmatched) continue;
    EXPECT_EQ(map[v], map[source.copies(v).front()]);
    EXPECT_EQ(map[v], target.copies(map[v]).front());
  }
}

/// That the last level has every vertex of both shapes once.
void expect_complete(const PaperResult& result, const Shape& source, const Shape& target) {
  EXPECT_TRUE(result.complete);
  EXPECT_EQ(result.levels.back().source_bases, source.num_surface_vertices());
  EXPECT_EQ(result.levels.back().target_bases, target.num_surface_vertices());
  expect_every_vertex_once(result.source_bases, source);
  expect_every_vertex_once(result.target_bases, target);
  expect_total(result.source_to_target, source, target);
}

/// The base vertices in the numbers of the surface.
std::vector<int> surface_bases(const Shape& shape, std::span<const int> bases) {
  return *on_surface(*shape.prepared().surface(), bases, "base");
}

/// Two poses of one creature, matched once for all tests.
class PaperPoses : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    creatures_ = {synthesize({"creature", 1000, 1, 1}), synthesize({"creature", 1000, 2, 1})};
    source_.emplace(creatures_[0].mesh);
    target_.emplace(creatures_[1].mesh);
    result_ = match_paper(*source_, *target_);
  }
  static void TearDownTestSuite() {
    creatures_ = {};
    source_.reset();
    target_.reset();
    result_ = {};
  }

  /// In the numbers of the surface.
  static std::vector<int> source_bases(int level) {
    const auto count = static_cast<std::size_t>(result_.levels[level].source_bases);
    return surface_bases(*source_, {result_.source_bases.data(), count});
  }

  static MetricSurface source_surface() { return source_->prepared().metric({}); }

  static std::array<SynthShape, 2> creatures_;
  static std::optional<Shape> source_, target_;
  static PaperResult result_;
};

std::array<SynthShape, 2> PaperPoses::creatures_;
std::optional<Shape> PaperPoses::source_, PaperPoses::target_;
PaperResult PaperPoses::result_;

TEST_F(PaperPoses, MatchEveryBaseOfBothShapesOnEveryLevel) { expect_covering(result_); }

TEST_F(PaperPoses, EndWithEveryVertexOfBothShapes) { expect_complete(result_, *source_, *target_); }

TEST_F(PaperPoses, BeginWithFewExtremitiesAndNestTheirBases) {
  const PaperLevel& coarsest = result_.levels.front();
  EXPECT_LE(std::max(coarsest.source_bases, coarsest.target_bases), 8);
  EXPECT_EQ(result_.source_bases.front(),
            descending_order(integral_geodesic_distance(*source_)).front());
  for (std::size_t k = 1; k < result_.levels.size(); ++k) {
    EXPECT_GE(result_.levels[k].source_bases, result_.levels[k - 1].source_bases);
    EXPECT_GE(result_.levels[k].target_bases, result_.levels[k - 1].target_bases);
  }
}

TEST_F(PaperPoses, LeaveNoVertexOutsideThePatchesOfALevel) {
  const MetricSurface surface = source_surface();
  GeodesicSearch search(surface.graph());
  for (std::size_t k = 0; k < result_.levels.size(); ++k) {
    const SourcePartition nearest = search.nearest_source(source_bases(static_cast<int>(k)));
    // Up to the rounding of the units.
    EXPECT_LE(std::ranges::max(nearest.distances) * std::sqrt(source_->area()),
              result_.levels[k].source_radius * (1 + 1e-12));
  }
}

TEST_F(PaperPoses, AreSampledAlikeWithoutMatching) {
  for (const int level : {0, 2, 1000}) {
    const std::size_t k = std::min<std::size_t>(level, result_.levels.size() - 1);
    const JointSampling sampling = sample_jointly(*source_, *target_, level);
    const auto first = [](const std::vector<int>& bases, int count) {
      return std::vector<int>(bases.begin(), bases.begin() + count);
    };
    EXPECT_EQ(sampling.source, first(result_.source_bases, result_.levels[k].source_bases));
    EXPECT_EQ(sampling.target, first(result_.target_bases, result_.levels[k].target_bases));
  }
  EXPECT_THROW(sample_jointly(*source_, *target_, -1), InvalidInput);
}

TEST_F(PaperPoses, HaveTheImagesOfTheLastLevel) {
  const std::vector<int>& image = result_.levels.back().many_to_one;
  ASSERT_EQ(image.size(), result_.source_bases.size());
  const Correspondence& matches = result_.levels.back().matches;
  for (std::size_t s = 0; s < image.size(); ++s) {
    const int target = result_.source_to_target[result_.source_bases[s]];
    const auto base = std::ranges::find(result_.target_bases, target);
    const Match match{static_cast<int>(s), static_cast<int>(base - result_.target_bases.begin())};
    EXPECT_TRUE(std::ranges::binary_search(matches, match));
  }
}

TEST_F(PaperPoses, AreMatchedAlikeInUnitsBeyondTheRangeOf32Bits) {
  for (const double unit : {std::exp2(-200), std::exp2(200)}) {
    const Shape source(test::scaled(creatures_[0].mesh, unit));
    const Shape target(test::scaled(creatures_[1].mesh, 1 / unit));
    const PaperResult result = match_paper(source, target);
    EXPECT_EQ(result.source_to_target, result_.source_to_target);
    EXPECT_DOUBLE_EQ(result.levels[1].source_radius, unit * result_.levels[1].source_radius);
  }
}

TEST_F(PaperPoses, ShrinkTheRadiusByTheRule) {
  const RadiusOptions options;
  const double unit = std::sqrt(source_->area());
  for (std::size_t k = 1; k < result_.levels.size(); ++k) {
    const double previous = result_.levels[k - 1].source_radius / unit;
    const BaseSampling sampling = sample_bases(
        source_surface(), {}, source_bases(static_cast<int>(k) - 1), static_cast<float>(previous));
    const double rule =
        options.radius_factor * std::sqrt(sampling.largest_patch_area / std::numbers::pi);
    const bool full =
        result_.levels[k - 1].source_bases >= options.full_share * source_->num_vertices();
    const double expected = full ? 0 : std::min(rule, options.max_radius_ratio * previous);
    EXPECT_NEAR(result_.levels[k].source_radius / unit, expected, 1e-6 * expected);
    EXPECT_LT(result_.levels[k].source_radius, result_.levels[k - 1].source_radius);
    EXPECT_LT(result_.levels[k].target_radius, result_.levels[k - 1].target_radius);
  }
}

/// Mean and maximum of Equation 2 over `matches`, against the list of matches of `landmarks`, by
/// base. A landmark of several matches counts with the one that `primary` names, if it is one.
class PlainDistortion {
 public:
  PlainDistortion(const Shape& source, const Shape& target, const PaperResult& result, int level,
                  const std::vector<int>& landmarks)
      : source_bases_(surface_bases(source, result.source_bases)),
        target_bases_(surface_bases(target, result.target_bases)),
        matches_(result.levels[level].matches) {
    const std::vector<int>& primary = result.levels[level].many_to_one;
    for (int s : landmarks) {
      const auto own = std::ranges::equal_range(matches_, s, {}, &Match::source);
      const bool kept = std::ranges::find(own, Match{s, primary[s]}) != own.end();
      list_.push_back({s, kept ? primary[s] : own.front().target});
      source_fields_.push_back(normalized_field(source, source_bases_[s]));
      target_fields_.push_back(normalized_field(target, target_bases_[list_.back().target]));
    }
  }

  DistortionSummary summary() const {
    DistortionSummary summary;
    for (const Match& match : matches_) {
      const double value = distortion(match);
      summary.mean += value / static_cast<double>(matches_.size());
      summary.max = std::max(summary.max, value);
    }
    return summary;
  }

 private:
  static std::vector<double> normalized_field(const Shape& shape, int vertex) {
    const MetricSurface surface = shape.prepared().metric({});
    std::vector<float> field(surface.num_vertices());
    GeodesicSearch(surface.graph()).field(vertex, field);
    std::vector<double> normalized(field.begin(), field.end());
    for (double& distance : normalized) distance /= surface.max_geodesic();
    return normalized;
  }

  double distortion(const Match& match) const {
    double sum = 0;
    int count = 0;
    for (std::size_t e = 0; e < list_.size(); ++e) {
      if (list_[e].source == match.source) continue;
      sum += std::abs(source_fields_[e][source_bases_[match.source]] -
                      target_fields_[e][target_bases_[match.target]]);
      ++count;
    }
    return sum / count;
  }

  std::vector<int> source_bases_, target_bases_;
  const Correspondence& matches_;
  Correspondence list_;
  std::vector<std::vector<double>> source_fields_, target_fields_;
};

TEST_F(PaperPoses, ReportTheDistortionOfEquationsOneAndTwo) {
  const int list_size = PaperOptions{}.list_size;
  const MetricSurface surface = source_surface();
  std::vector<int> landmarks;
  for (int k = 0; k < static_cast<int>(result_.levels.size()); ++k) {
    if (static_cast<int>(landmarks.size()) < list_size)
      landmarks = farthest_points(surface.graph(), source_bases(std::max(0, k - 1)), list_size);
    const DistortionSummary plain =
        PlainDistortion(*source_, *target_, result_, k, landmarks).summary();
    // Equal up to the choice among several matches of a landmark, which lie next to each other.
    const DistortionSummary reported = summarize(result_.levels[k].distortion);
    EXPECT_NEAR(reported.mean, plain.mean, 0.05 * plain.mean) << k;
    EXPECT_NEAR(reported.max, plain.max, 0.15 * plain.max) << k;
  }
}

TEST_F(PaperPoses, AreMatchedAtLittleDistortion) {
  // Geodesic distances between two poses differ by about one percent of the largest; to be half an
  // edge (1.2 %) off would add about as much. Measured over six creatures: .009 to .010.
  EXPECT_LT(summarize(result_.levels.back().distortion).mean, 0.015);
}

TEST_F(PaperPoses, AreMatchedToWithinAnEdgeUpToTheFlip) {
  // The method cannot tell a shape from its mirror image, so either map counts.
  double direct = 0, flipped = 0;
  const Correspondence& matches = result_.levels.back().matches;
  for (const auto& [s, t] : matches) {
    Point from = creatures_[0].rest[result_.source_bases[s]];
    const Point& to = creatures_[1].rest[result_.target_bases[t]];
    direct += (from - to).norm() / static_cast<double>(matches.size());
    from.x() = -from.x();
    flipped += (from - to).norm() / static_cast<double>(matches.size());
  }
  EXPECT_LT(std::min(direct, flipped), GeodesicGraph(source_->mesh()).mean_edge_length());
}

bool equal(const PaperLevel& a, const PaperLevel& b) {
  return a.source_radius == b.source_radius && a.target_radius == b.target_radius &&
         a.source_bases == b.source_bases && a.target_bases == b.target_bases &&
         a.many_to_one == b.many_to_one && a.matches == b.matches && a.distortion == b.distortion &&
         a.many_to_one_distortion == b.many_to_one_distortion &&
         a.outliers_moved == b.outliers_moved;
}

TEST(Paper, ThreadsChangeNothing) {
  const auto matched = [](int threads) {
    const Context context = test::with_threads(threads);
    const Shape source(creature(1000, 1, 2)), target(creature(1000, 2, 2));
    return match_paper(source, target, {}, context);
  };
  const PaperResult one = matched(1), two = matched(2);
  EXPECT_EQ(one.source_bases, two.source_bases);
  EXPECT_EQ(one.target_bases, two.target_bases);
  EXPECT_TRUE(std::ranges::equal(one.levels, two.levels, equal));
}

/// The paper's method turns them over, as its authors say of it.
TEST(Paper, PairsAreNotTurnedOverIfOrientationIsKept) {
  for (const std::uint64_t seed : {3, 4}) {
    const Shape source(creature(1000, 1, seed)), target(creature(1000, 2, seed));
    const auto verdict = [&](bool orientation) {
      PaperOptions options;
      options.max_levels = 5;
      options.keep_orientation = orientation;
      const VertexMap map = match_paper(source, target, options).source_to_target;
      return map_orientation(source, target, to_correspondence(map)).verdict;
    };
    EXPECT_EQ(verdict(false), OrientationVerdict::kReverses) << seed;
    EXPECT_EQ(verdict(true), OrientationVerdict::kPreserves) << seed;
  }
}

TEST(Paper, EndsAfterTheLevelsWanted) {
  const Shape source(creature(1000, 1, 3)), target(creature(1000, 2, 3));
  PaperOptions options;
  options.coarse_candidates = 1;
  options.max_levels = 3;
  const PaperResult longest = match_paper(source, target, options);
  for (options.max_levels = 0; options.max_levels <= 3; ++options.max_levels) {
    const PaperResult result = match_paper(source, target, options);
    ASSERT_EQ(result.levels.size(), options.max_levels + 1);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(result.source_bases.size(), result.levels.back().source_bases);
    EXPECT_EQ(result.target_bases.size(), result.levels.back().target_bases);
    EXPECT_TRUE(
        std::equal(result.levels.begin(), result.levels.end(), longest.levels.begin(), equal));
  }
}

TEST(Paper, MatchesShapesOfAnyKind) {
  const Shape sphere(test::icosphere(2));
  for (const test::ZooMesh& zoo_mesh : test::mesh_zoo()) {
    SCOPED_TRACE(zoo_mesh.name);
    const Shape shape(zoo_mesh.mesh);
    for (const auto& [source, target] : {std::pair{&shape, &sphere}, {&sphere, &shape}}) {
      const PaperResult result = match_paper(*source, *target);
      expect_covering(result);
      expect_complete(result, *source, *target);
    }
  }
}

TEST(Paper, MatchesASingleTriangle) {
  const Shape triangle(Mesh{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}});
  const Shape sphere(test::icosphere(1));
  for (const auto& [source, target] :
       {std::pair{&triangle, &triangle}, {&triangle, &sphere}, {&sphere, &triangle}}) {
    const PaperResult result = match_paper(*source, *target);
    expect_covering(result);
    expect_complete(result, *source, *target);
  }
}

/// Of the matches of the last level those that `target_of_source` does not have.
Correspondence wrong_matches(const PaperResult& result, const std::vector<int>& target_of_source) {
  Correspondence wrong;
  for (const auto& [s, t] : result.levels.back().matches) {
    const int from = result.source_bases[s];
    const int to = result.target_bases[t];
    if (target_of_source[from] != to) wrong.push_back({from, to});
  }
  return wrong;
}

/// That `mesh` is matched to `copy`, which has new numbers for its vertices, without an error.
void expect_found_again(const Mesh& mesh, const Mesh& copy, const std::vector<int>& new_vertex) {
  const Shape source(mesh), target(copy);
  const PaperResult result = match_paper(source, target);
  expect_complete(result, source, target);
  EXPECT_EQ(wrong_matches(result, new_vertex), Correspondence{});
  EXPECT_EQ(result.source_to_target, new_vertex);
}

void expect_identity(const Mesh& mesh) {
  std::vector<int> identity(mesh.vertices.size());
  std::iota(identity.begin(), identity.end(), 0);
  expect_found_again(mesh, mesh, identity);
}

void expect_relabelling(const Mesh& mesh) {
  test::Random random(1);
  const test::Relabelled copy = test::relabelled(mesh, random);
  expect_found_again(mesh, test::scaled(test::moved(copy.mesh, random), 3), copy.new_vertex);
}

TEST(Paper, MatchesACreatureToItself) { expect_identity(creature(1500, 1, 1)); }

TEST(Paper, FindsACreatureNumberedAnewTurnedMovedAndScaled) {
  expect_relabelling(creature(1500, 1, 1));
}

TEST(Paper, FindsACreatureThatIsItsOwnMirrorImage) { expect_relabelling(creature(1500, 0, 4)); }

TEST(Paper, FindsALargerCreature) { expect_relabelling(creature(3000, 3, 2)); }

class PaperData : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(path_)) GTEST_SKIP() << path_ << " is absent";
  }

  const std::string path_ = test::data_path("tosca5k/" + GetParam() + ".off");
};

TEST_P(PaperData, IsMatchedToItself) { expect_identity(read_mesh(path_)); }

TEST_P(PaperData, IsFoundNumberedAnewTurnedMovedAndScaled) { expect_relabelling(read_mesh(path_)); }

INSTANTIATE_TEST_SUITE_P(Animals, PaperData, testing::Values("horse0", "centaur0"),
                         [](const auto& test) { return test.param; });

template <class Change>
void expect_rejected(const Change& change) {
  static const Shape sphere(test::icosphere(0));
  PaperOptions options;
  change(options);
  EXPECT_THROW(options.validate(), InvalidInput);
  EXPECT_THROW(match_paper(sphere, sphere, options), InvalidInput);
}

TEST(PaperOptions, OfStagesAreChecked) {
  EXPECT_NO_THROW(PaperOptions{}.validate());
  expect_rejected([](PaperOptions& o) { o.saliency.integral_points = 0; });
  expect_rejected([](PaperOptions& o) { o.patches.max_patch_bases = 0; });
  expect_rejected([](PaperOptions& o) { o.merging.outlier_rounds = -1; });
}

TEST(PaperOptions, OutOfRangeAreRejected) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const int number : {-1, 0}) {
    expect_rejected([=](PaperOptions& o) { o.list_size = number; });
    expect_rejected([=](PaperOptions& o) { o.coarse_candidates = number; });
    expect_rejected([=](PaperOptions& o) { o.candidate_levels = number; });
    expect_rejected([=](PaperOptions& o) { o.radii.max_coarse_bases = number; });
  }
  expect_rejected([](PaperOptions& o) { o.max_levels = -1; });
  for (const double number : {-0.5, 0.0, kNan}) {
    expect_rejected([=](PaperOptions& o) { o.radii.radius_factor = number; });
    expect_rejected([=](PaperOptions& o) { o.radii.max_radius_ratio = number; });
  }
  expect_rejected([](PaperOptions& o) { o.radii.max_radius_ratio = 1; });
}

TEST(Paper, StopsWhenAsked) {
  const Shape sphere(test::icosphere(1));
  std::stop_source stop;
  stop.request_stop();
  Context context;
  context.stop = stop.get_token();
  EXPECT_THROW(match_paper(sphere, sphere, {}, context), Cancelled);
}

}  // namespace
}  // namespace isomatch
