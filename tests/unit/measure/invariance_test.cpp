// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// Measures are those of the shapes, whatever their units, place and numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "isomatch/measure/fit.h"
#include "isomatch/measure/metrics.h"
#include "isomatch/mesh/synth.h"
#include "isomatch/mesh/topology.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"

namespace isomatch {
namespace {

/// Two meshes and a map between them.
struct Mapped {
  Mesh source, target;
  GroundTruth truth;
  SurfaceMap points;

  Correspondence matches() const { return to_correspondence(nearest_vertices(target, points)); }
};

/// All figures that measure a map.
struct Figures {
  ErrorStatistics template_errors, point_errors, match_errors;
  std::vector<double> vertex_errors, per_match;
  IsometricDistortion distortion, listed_distortion;
  Coverage coverage;
  MapOrientation orientation;
  FitMeasures fit;
};

Figures measure(const Mapped& mapped) {
  const Shape source(mapped.source), target(mapped.target);
  const Correspondence matches = mapped.matches();
  const GroundTruth& truth = mapped.truth;
  Figures figures;
  figures.template_errors = template_errors(source, target, truth, matches);
  figures.point_errors = point_errors(source, target, truth, mapped.points);
  figures.match_errors = match_errors(source, target, truth, matches);
  figures.vertex_errors = vertex_errors(source, target, truth, mapped.points);
  figures.distortion = isometric_distortion(source, target, matches, {.list_size = 100'000});
  figures.listed_distortion = isometric_distortion(source, target, matches, {.list_size = 200});
  figures.coverage = target_coverage(source, target, matches);
  figures.orientation = map_orientation(source, target, matches);
  figures.fit = judge_fit(source, target, mapped.points).measures;
  return figures;
}

/// Two poses, the vertices at the points of the target whose places at rest are a little off.
Mapped creatures() {
  SynthShape source = synthesize({.vertices = 1000, .pose = 1, .seed = 3});
  SynthShape target = synthesize({.vertices = 1000, .pose = 2, .seed = 3});
  test::Random random(1);
  SurfaceMap points;
  const IndexLists faces = vertex_faces(target.mesh);
  for (const Point& p : source.rest) {
    const auto distance = [&](const Point& q) { return (p - q).squaredNorm(); };
    const auto nearest = std::ranges::min_element(target.rest, {}, distance);
    const auto around = faces[static_cast<int>(nearest - target.rest.begin())];
    const double a = random.uniform(), b = (1 - a) * random.uniform();
    points.push_back({around[random.index(static_cast<int>(around.size()))], {a, b, 1 - a - b}});
  }
  return {std::move(source.mesh),
          std::move(target.mesh),
          {source.ground_truth, target.ground_truth},
          std::move(points)};
}

/// Distances are sums of 32-bit numbers.
constexpr double kRounding = 1e-6;

void expect_near(double a, double b) { EXPECT_NEAR(a, b, kRounding * std::abs(a)); }

void expect_near(const ErrorStatistics& a, const ErrorStatistics& b) {
  EXPECT_EQ(a.samples, b.samples);
  expect_near(a.mean, b.mean);
  expect_near(a.median, b.median);
  expect_near(a.p95, b.p95);
  expect_near(a.maximum, b.maximum);
}

/// `b` has the values of the vertices by their new numbers.
void expect_near(const std::vector<double>& a, const std::vector<double>& b,
                 const std::vector<int>& new_vertex) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t v = 0; v < a.size(); ++v) {
    const double other = b[new_vertex[v]];
    EXPECT_EQ(std::isnan(a[v]), std::isnan(other));
    if (std::isnan(a[v])) continue;
    EXPECT_NEAR(a[v], other, kRounding);
  }
}

/// Those that look at all there is.
void expect_same_in_full(const Figures& a, const Figures& b, const std::vector<int>& new_vertex) {
  expect_near(a.template_errors, b.template_errors);
  expect_near(a.point_errors, b.point_errors);
  expect_near(a.match_errors, b.match_errors);
  expect_near(a.vertex_errors, b.vertex_errors, new_vertex);
  expect_near(a.distortion.mean, b.distortion.mean);
  expect_near(a.distortion.maximum, b.distortion.maximum);
  expect_near(a.distortion.per_match, b.distortion.per_match, new_vertex);
  EXPECT_EQ(a.coverage.vertices, b.coverage.vertices);
  expect_near(a.coverage.area, b.coverage.area);
}

/// Those that look at evenly spread vertices, where these are the same.
void expect_same_at_samples(const Figures& a, const Figures& b) {
  expect_near(a.listed_distortion.mean, b.listed_distortion.mean);
  expect_near(a.listed_distortion.maximum, b.listed_distortion.maximum);
  EXPECT_EQ(a.orientation.verdict, b.orientation.verdict);
  EXPECT_EQ(a.orientation.votes, b.orientation.votes);
  expect_near(a.orientation.preserved_share, b.orientation.preserved_share);
  expect_near(a.orientation.mean_sign, b.orientation.mean_sign);
  expect_near(a.fit.stretch, b.fit.stretch);
  expect_near(a.fit.distorted, b.fit.distorted);
  expect_near(a.fit.displacement, b.fit.displacement);
  expect_near(a.fit.relief, b.fit.relief);
  expect_near(a.fit.unreached, b.fit.unreached);
  expect_near(a.fit.unmatched, b.fit.unmatched);
  expect_near(a.fit.reversed, b.fit.reversed);
}

/// A noisy map between two poses, and its measures.
class Measures : public testing::Test {
 protected:
  std::vector<int> same_numbers() const {
    std::vector<int> numbers(plain_.source.vertices.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }

  const Mapped plain_ = creatures();
  const Figures figures_ = measure(plain_);
};

TEST_F(Measures, DoNotDependOnUnitsNorOnTheOrigin) {
  Mapped changed = plain_;
  changed.source = test::scaled(plain_.source, 1000);
  for (Point& p : changed.source.vertices) p += Point(5000, -3000, 100);
  changed.target = test::scaled(plain_.target, 1e-3);
  const Figures figures = measure(changed);
  expect_same_in_full(figures_, figures, same_numbers());
  expect_same_at_samples(figures_, figures);
}

TEST_F(Measures, DoNotDependOnNumbers) {
  test::Random random(6);
  const test::Relabelled source = test::relabelled(plain_.source, random);
  const test::Relabelled target = test::relabelled(plain_.target, random);
  Mapped changed{source.mesh, target.mesh, plain_.truth, SurfaceMap(plain_.points.size())};
  for (int& v : changed.truth.source) v = source.new_vertex[v];
  for (int& v : changed.truth.target) v = target.new_vertex[v];
  for (std::size_t v = 0; v < plain_.points.size(); ++v) {
    const SurfacePoint& point = plain_.points[v];
    SurfacePoint& other = changed.points[source.new_vertex[v]];
    other.face = target.new_face[point.face];
    const Face& before = plain_.target.faces[point.face];
    const Face& after = target.mesh.faces[other.face];
    for (int k = 0; k < 3; ++k)
      other.weights[std::ranges::find(after, target.new_vertex[before[k]]) - after.begin()] =
          point.weights[k];
  }
  const Figures figures = measure(changed);
  expect_same_in_full(figures_, figures, source.new_vertex);
  expect_same_at_samples(figures_, figures);
}

TEST_F(Measures, OfTurnedShapesDifferByTheirSamplesOnly) {
  Mapped changed = plain_;
  test::Random random(5);
  changed.source = test::scaled(test::moved(plain_.source, random), 1000);
  changed.target = test::moved(test::scaled(plain_.target, 1e-3), random);
  const Figures figures = measure(changed);
  expect_same_in_full(figures_, figures, same_numbers());
  // Evenly spread vertices begin at one that depends on how the shape lies in space. Means over 200
  // or 300 of them, at which they scatter about as much as they are large, differ by some
  // sqrt(2 / 200) = 10 %; shares of a few such by a few of them.
  EXPECT_NEAR(figures.listed_distortion.mean, figures_.listed_distortion.mean,
              0.1 * figures_.listed_distortion.mean);
  EXPECT_EQ(figures.orientation.verdict, figures_.orientation.verdict);
  EXPECT_NEAR(figures.orientation.preserved_share, figures_.orientation.preserved_share, 0.02);
  EXPECT_NEAR(figures.fit.stretch, figures_.fit.stretch, 0.1 * figures_.fit.stretch);
  EXPECT_NEAR(figures.fit.distorted, figures_.fit.distorted, 0.01);
  EXPECT_NEAR(figures.fit.displacement, figures_.fit.displacement, 0.1 * figures_.fit.displacement);
  EXPECT_NEAR(figures.fit.relief, figures_.fit.relief, 0.02);
  EXPECT_NEAR(figures.fit.reversed, figures_.fit.reversed, 0.01);
}

}  // namespace
}  // namespace isomatch
