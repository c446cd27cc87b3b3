// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/shape/shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stop_token>
#include <thread>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "shape/prepared_shape.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"

namespace isomatch {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<int> copies(const Shape& shape, int vertex) {
  const auto all = shape.copies(vertex);
  return {all.begin(), all.end()};
}

TEST(Shape, KeepsTheMeshAsItIs) {
  for (const test::ZooMesh& zoo_mesh : test::mesh_zoo()) {
    const Shape shape(zoo_mesh.mesh);
    EXPECT_EQ(shape.mesh().vertices, zoo_mesh.mesh.vertices);
    EXPECT_EQ(shape.mesh().faces, zoo_mesh.mesh.faces);
    EXPECT_EQ(shape.num_vertices(), zoo_mesh.mesh.num_vertices());
  }
}

TEST(Shape, CopiesAreTheVerticesAtOnePlace) {
  const Mesh charts = test::sphere_of_charts();
  const Shape shape(charts);
  for (int v = 0; v < charts.num_vertices(); ++v) {
    std::vector<int> expected;
    for (int w = 0; w < charts.num_vertices(); ++w)
      if (charts.vertices[w] == charts.vertices[v]) expected.push_back(w);
    EXPECT_EQ(copies(shape, v), expected);
  }
}

TEST(Shape, CopiesOfTheSpareVerticesAtAPole) {
  const Shape shape(test::uv_sphere(16, 8));
  EXPECT_EQ(shape.copies(3).size(), 17);
  EXPECT_EQ(copies(shape, 3), copies(shape, 0));
  EXPECT_EQ(shape.num_surface_vertices(), 16 * 7 + 2);
}

TEST(Shape, VerticesOffTheSurfaceHaveNoCopies) {
  const Shape spheres(test::three_spheres());
  for (int v = 0; v < spheres.num_vertices(); ++v) {
    const bool in_the_largest = v / 162 == 1;
    EXPECT_EQ(spheres.on_surface(v), in_the_largest);
    EXPECT_EQ(copies(spheres, v), in_the_largest ? std::vector{v} : std::vector<int>{});
  }
  const Shape loose(test::sphere_with_unreferenced_vertices());
  EXPECT_FALSE(loose.on_surface(0));
  EXPECT_THAT(copies(loose, 0), IsEmpty());
  EXPECT_THAT(copies(loose, 2), ElementsAre(2));
}

TEST(Shape, VerticesOutOfRangeThrow) {
  const Shape shape(test::icosphere(1));
  for (const int vertex : {-1, 42, 1'000'000}) {
    EXPECT_THROW(shape.on_surface(vertex), InvalidInput);
    EXPECT_THROW(shape.copies(vertex), InvalidInput);
  }
}

TEST(Shape, LengthsAndAreasAreInUnitsOfTheMesh) {
  for (const double radius : {1e-20, 1.0, 300.0}) {
    const Mesh mesh = test::icosphere(4, radius);
    const Shape shape(mesh);
    // The square of a root.
    EXPECT_NEAR(shape.area(), surface_area(mesh), 1e-14 * surface_area(mesh));
    // The visibility graph's .2 % on average; the chords cut corners off.
    EXPECT_NEAR(shape.max_geodesic(), std::numbers::pi * radius, 0.01 * radius);
  }
}

TEST(Shape, MeasuresByTheGeodesicsItWasMadeFor) {
  const Mesh mesh = test::icosphere(3);
  const Shape plain(mesh), by_edges(mesh, GeodesicOptions::edges());
  EXPECT_GT(by_edges.max_geodesic(), 1.02 * plain.max_geodesic());
  EXPECT_EQ(plain.max_geodesic(), Shape(mesh).max_geodesic());
}

TEST(Shape, KnowsWhatIsWrongWithTheMesh) {
  for (const test::ZooMesh& zoo_mesh : test::mesh_zoo())
    EXPECT_EQ(Shape(zoo_mesh.mesh).diagnosis().warnings(), diagnose(zoo_mesh.mesh).warnings());
}

TEST(Shape, RefusesWhatCannotBePrepared) {
  const Mesh line{{Point(0, 0, 0), Point(1, 1, 1), Point(2, 2, 2)}, {{0, 1, 2}, {0, 0, 1}}};
  EXPECT_THROW(Shape{line}, InvalidInput);
  EXPECT_THROW(Shape{Mesh{}}, InvalidInput);
  EXPECT_THROW(Shape{test::scaled(test::icosphere(1), 1e101)}, InvalidInput);
  Mesh invalid = test::icosphere(1);
  invalid.faces[3][1] = 42;
  EXPECT_THROW(Shape{invalid}, InvalidInput);
  EXPECT_THROW(Shape(test::icosphere(1), {.window_angle = 0}), InvalidInput);
}

TEST(Shape, ACopySharesWhatIsPrepared) {
  const Shape shape(test::icosphere(2));
  const Shape copy = shape;  // NOLINT(performance-unnecessary-copy-initialization): it is tested.
  EXPECT_EQ(&copy.prepared(), &shape.prepared());
  EXPECT_EQ(&copy.prepared().metric({}).graph(), &shape.prepared().metric({}).graph());
}

TEST(Shape, IsPreparedOnce) {
  const Shape shape(test::rough_sphere(3, 0.1, 1));
  const PreparedShape& prepared = shape.prepared();
  EXPECT_EQ(&prepared.metric({}).graph(), &prepared.metric({}).graph());
  EXPECT_EQ(prepared.graph({}, {}).get(), &prepared.metric({}).graph());
  EXPECT_NE(prepared.graph(GeodesicOptions::edges(), {}), prepared.graph({}, {}));
  EXPECT_EQ(prepared.graph(GeodesicOptions::edges(), {}),
            prepared.graph(GeodesicOptions::edges(), {}));
  EXPECT_EQ(&prepared.kept<std::vector<int>>(), &prepared.kept<std::vector<int>>());
}

TEST(Shape, WhatWasCancelledIsMadeTheNextTime) {
  const Shape shape(test::rough_sphere(3, 0.1, 1));
  std::stop_source stop;
  stop.request_stop();
  Context stopped;
  stopped.stop = stop.get_token();
  EXPECT_THROW(shape.max_geodesic(stopped), Cancelled);
  EXPECT_EQ(shape.max_geodesic(), Shape(shape.mesh()).max_geodesic());
}

TEST(Shape, IsPreparedOnceForAllThreads) {
  const Shape shape(test::rough_sphere(4, 0.1, 1));
  constexpr std::size_t kThreads = 8;
  std::vector<const GeodesicGraph*> graphs(kThreads);
  std::vector<double> lengths(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < kThreads; ++i)
      threads.emplace_back([&, i] {
        lengths[i] = shape.max_geodesic();
        graphs[i] = &shape.prepared().metric({}).graph();
      });
  }
  EXPECT_EQ(std::ranges::count(graphs, graphs.front()), kThreads);
  EXPECT_EQ(std::ranges::count(lengths, Shape(shape.mesh()).max_geodesic()), kThreads);
}

}  // namespace
}  // namespace isomatch
