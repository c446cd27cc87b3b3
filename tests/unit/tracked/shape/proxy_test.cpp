// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/proxy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "isomatch/mesh/topology.h"
#include "support/context.h"
#include "support/mesh_files.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/zoo.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

using test::Prepared;

constexpr ProxyOptions kSmall{.vertices = 400, .nodes = 150};

const Mesh& creature() {
  static const Mesh mesh = synthesize({.vertices = 3000, .pose = 1}).mesh;
  return mesh;
}

/// That the vertices are the surface's, scaled and moved, and their numbers in range and distinct.
void expect_subset(const Prepared& prepared) {
  const auto& [shape, surface, detail, proxy] = prepared;
  ASSERT_EQ(proxy.detail_vertex.size(), proxy.mesh.vertices.size());
  EXPECT_EQ(std::set<int>(proxy.detail_vertex.begin(), proxy.detail_vertex.end()).size(),
            proxy.mesh.vertices.size());
  const auto& original = shape.mesh().vertices;
  for (int v = 0; v < proxy.num_vertices(); ++v) {
    ASSERT_LT(proxy.detail_vertex[v], surface.num_vertices());
    const Point place = surface.scale * proxy.mesh.vertices[v] + surface.centre;
    const Point& expected = original[surface.input_vertex[proxy.detail_vertex[v]]];
    EXPECT_LT((place - expected).norm(), 1e-9 * surface.scale);
  }
}

/// That all is consistent and finite, whatever the surface.
// NOLINTNEXTLINE(readability-function-size): one expectation after the other.
void expect_sound(const Prepared& prepared) {
  const Proxy& proxy = prepared.proxy;
  expect_subset(prepared);
  EXPECT_NO_THROW(validate(proxy.mesh));
  ASSERT_EQ(proxy.normals.size(), proxy.mesh.vertices.size());
  for (const Point& normal : proxy.normals) EXPECT_TRUE(normal.allFinite());
  ASSERT_GE(proxy.num_nodes(), 1);
  EXPECT_EQ(std::set<int>(proxy.nodes.begin(), proxy.nodes.end()).size(), proxy.nodes.size());
  ASSERT_EQ(proxy.num_measured(), std::min(proxy.num_nodes(), ProxyOptions{}.measured_nodes));
  ASSERT_EQ(proxy.distances.cols(), proxy.num_vertices());
  EXPECT_TRUE(proxy.distances.allFinite());
  EXPECT_GE(proxy.distances.minCoeff(), 0);
}

bool is_connected(const IndexLists& neighbours) {
  std::vector<bool> seen(neighbours.size(), false);
  std::vector<int> open{0};
  seen[0] = true;
  int count = 0;
  while (!open.empty()) {
    const int a = open.back();
    open.pop_back();
    ++count;
    for (int b : neighbours[a]) {
      if (!seen[b]) open.push_back(b);
      seen[b] = true;
    }
  }
  return count == neighbours.size();
}

// NOLINTNEXTLINE(readability-function-size): one expectation after the other.
void expect_graph(const Proxy& proxy, int count) {
  const NodeGraph graph = node_graph(proxy, count);
  count = std::min(count, proxy.num_nodes());
  ASSERT_EQ(graph.neighbours.size(), count);
  ASSERT_EQ(graph.cloud.areas.size(), count);
  EXPECT_TRUE(is_connected(graph.neighbours));
  const double area = std::accumulate(graph.cloud.areas.begin(), graph.cloud.areas.end(), 0.0);
  EXPECT_NEAR(area, surface_area(proxy.mesh), 1e-9);
  for (int i = 0; i < count; ++i) {
    EXPECT_EQ(graph.cloud.positions[i], proxy.node_position(i));
    EXPECT_EQ(graph.cloud.normals[i], proxy.node_normal(i));
    EXPECT_TRUE(std::ranges::is_sorted(graph.neighbours[i]));
    for (int j : graph.neighbours[i]) {
      EXPECT_NE(i, j);
      EXPECT_TRUE(std::ranges::binary_search(graph.neighbours[j], i));
    }
  }
}

TEST(Proxy, IsASmallerCopyOfUnitArea) {
  const Prepared prepared(test::scaled(creature(), 20), kSmall);
  expect_sound(prepared);
  const Proxy& proxy = prepared.proxy;
  EXPECT_NEAR(proxy.num_vertices(), kSmall.vertices, 0.02 * kSmall.vertices);
  EXPECT_EQ(proxy.num_nodes(), kSmall.nodes);
  // Chords cut corners off.
  EXPECT_LT(surface_area(proxy.mesh), 1);
  EXPECT_GT(surface_area(proxy.mesh), 0.9);
}

TEST(Proxy, OfFewVerticesIsTheSurfaceItself) {
  const Prepared prepared(test::icosphere(2, 3));
  expect_sound(prepared);
  EXPECT_EQ(prepared.proxy.num_vertices(), 162);
  EXPECT_EQ(prepared.proxy.num_nodes(), 162);
  EXPECT_NEAR(surface_area(prepared.proxy.mesh), 1, 1e-9);
}

TEST(Proxy, DistancesAreThoseOfTheSphere) {
  const Proxy proxy = Prepared(test::icosphere(4), {.vertices = 1000, .nodes = 100}).proxy;
  const double radius = 1 / std::sqrt(4 * std::numbers::pi);
  double error = 0, total = 0;
  for (int a = 0; a < proxy.num_nodes(); ++a) {
    EXPECT_EQ(proxy.node_distance(a, a), 0);
    for (int b = 0; b < proxy.num_nodes(); ++b) {
      EXPECT_NEAR(proxy.node_distance(a, b), proxy.node_distance(b, a), 1e-5);
      const double cosine =
          proxy.node_position(a).normalized().dot(proxy.node_position(b).normalized());
      const double expected = radius * std::acos(std::clamp(cosine, -1.0, 1.0));
      EXPECT_NEAR(proxy.node_distance(a, b), expected, 0.03 * expected + 1e-4);
      error += std::abs(proxy.node_distance(a, b) - expected);
      total += expected;
    }
  }
  EXPECT_LT(error, 0.005 * total);
}

TEST(Proxy, NodesAreFarthestPoints) {
  const Proxy proxy = Prepared(creature(), kSmall).proxy;
  std::vector<float> nearest(proxy.num_vertices(), std::numeric_limits<float>::max());
  for (int i = 0; i < proxy.num_nodes(); ++i) {
    EXPECT_EQ(nearest[proxy.nodes[i]], std::ranges::max(nearest));
    for (int v = 0; v < proxy.num_vertices(); ++v)
      nearest[v] = std::min(nearest[v], proxy.distances(i, v));
  }
}

TEST(Proxy, DistancesAreMeasuredFromTheFirstNodes) {
  ProxyOptions options = kSmall;
  options.measured_nodes = 40;
  const Proxy all = Prepared(creature(), kSmall).proxy;
  const Proxy some = Prepared(creature(), options).proxy;
  EXPECT_EQ(some.nodes, all.nodes);
  ASSERT_EQ(some.num_measured(), 40);
  EXPECT_EQ(some.distances, all.distances.topRows(40));
  const NodeGraph graph = node_graph(some, kSmall.nodes), same = node_graph(all, kSmall.nodes);
  EXPECT_EQ(graph.cloud.areas, same.cloud.areas);
  expect_graph(some, kSmall.nodes);
}

TEST(Proxy, NormalsFaceOutwardsHoweverFacesAreTurned) {
  Mesh turned = test::icosphere(4);
  for (Face& face : turned.faces) std::swap(face[0], face[1]);
  Mesh spotted = test::icosphere(4);
  for (int f = 0; f < spotted.num_faces(); f += 10)
    std::swap(spotted.faces[f][0], spotted.faces[f][1]);
  for (const Mesh& mesh : {test::icosphere(4), turned, spotted}) {
    const Proxy proxy = Prepared(mesh, kSmall).proxy;
    EXPECT_TRUE(proxy.oriented);
    for (int v = 0; v < proxy.num_vertices(); ++v)
      EXPECT_GT(proxy.normals[v].dot(proxy.mesh.vertices[v].normalized()), 0.95);
  }
}

TEST(Proxy, KnowsWhenThereIsNoOutside) {
  EXPECT_FALSE(Prepared(test::moebius_strip(24)).proxy.oriented);
  Mesh mesh = test::icosphere(3);
  test::Random random(1);
  for (Face& face : mesh.faces)
    if (random.uniform() < 0.5) std::swap(face[0], face[1]);
  EXPECT_FALSE(Prepared(mesh).proxy.oriented);
}

TEST(Proxy, ThreadsChangeNothing) {
  const Proxy one = Prepared(creature(), kSmall, test::with_threads(1)).proxy;
  const Proxy three = Prepared(creature(), kSmall, test::with_threads(3)).proxy;
  EXPECT_EQ(one.detail_vertex, three.detail_vertex);
  EXPECT_EQ(one.mesh.faces, three.mesh.faces);
  EXPECT_EQ(one.nodes, three.nodes);
  EXPECT_EQ(one.distances, three.distances);
}

TEST(NodeGraph, IsConnectedAndSymmetric) {
  const Proxy proxy = Prepared(creature(), kSmall).proxy;
  for (const int count : {1, 2, 10, 50, kSmall.nodes, 10 * kSmall.nodes})
    expect_graph(proxy, count);
}

TEST(NodeGraph, OfAllVerticesHasTheEdgesOfTheMesh) {
  const Proxy proxy = Prepared(test::icosphere(2)).proxy;
  const NodeGraph graph = node_graph(proxy, 162);
  int edges = 0;
  for (int i = 0; i < 162; ++i) edges += static_cast<int>(graph.neighbours[i].size());
  EXPECT_EQ(edges, 2 * 480);
}

Proxy open_proxy(const Mesh& mesh) { return Prepared(mesh, {}, {}, true).proxy; }

TEST(ProxyBoundary, OfAnOpenSheetIsItsRim) {
  const Proxy proxy = open_proxy(test::sheet(30, 30));
  ASSERT_EQ(proxy.num_vertices(), 31 * 31);
  for (int v = 0; v < proxy.num_vertices(); ++v) {
    const double expected = 0.5 - proxy.mesh.vertices[v].cwiseAbs().maxCoeff();
    EXPECT_NEAR(proxy.to_boundary[v], expected, 1e-5);
    if (expected < 1e-9) {
      EXPECT_EQ(proxy.to_boundary[v], 0);
    }
  }
}

TEST(ProxyBoundary, IsInfinitelyFarWhereNothingIsMissing) {
  for (const Proxy& proxy : {open_proxy(test::icosphere(2)), Prepared(test::sheet(6, 4)).proxy}) {
    ASSERT_EQ(std::ssize(proxy.to_boundary), proxy.num_vertices());
    for (const float distance : proxy.to_boundary) EXPECT_TRUE(std::isinf(distance));
    for (int a = 0; a < proxy.num_measured(); ++a)
      for (int b = 0; b < proxy.num_nodes(); ++b)
        EXPECT_EQ(proxy.least_distance(a, b), proxy.node_distance(a, b));
  }
}

TEST(ProxyBoundary, LeastDistancesAreNoLongerAndShortenOnlyWhatIsLongerThanTheWaysToTheRim) {
  const Proxy proxy = open_proxy(test::sheet(30, 30));
  const auto from_centre = [&](int node) {
    return proxy.node_position(node).cwiseAbs().maxCoeff();
  };
  int inner = 0, outer = 0;
  for (int a = 0; a < proxy.num_measured(); ++a) {
    for (int b = 0; b < proxy.num_nodes(); ++b) {
      EXPECT_LE(proxy.least_distance(a, b), proxy.node_distance(a, b));
      const double farthest = std::max(from_centre(a), from_centre(b));
      const double nearest = std::min(from_centre(a), from_centre(b));
      if (farthest < 0.2) {
        EXPECT_EQ(proxy.least_distance(a, b), proxy.node_distance(a, b));
        ++inner;
      } else if (nearest > 0.499) {
        EXPECT_NEAR(proxy.least_distance(a, b), 0, 1e-6);
        ++outer;
      }
    }
  }
  EXPECT_GT(inner, 100);
  EXPECT_GT(outer, 100);
}

/// Two spheres that are not connected, as simplification may leave them.
Detail two_spheres() {
  Mesh small = test::icosphere(2, 0.3);
  for (Point& p : small.vertices) p.x() += 3;
  const Mesh mesh = test::scaled(test::combined(test::icosphere(3), small), 0.25);
  std::vector<int> all(mesh.vertices.size());
  std::iota(all.begin(), all.end(), 0);
  auto graph = std::make_shared<const GeodesicGraph>(mesh);
  return {mesh, std::move(all), vertex_faces(mesh),
          std::vector<elastic::Features>(mesh.vertices.size()), std::move(graph)};
}

TEST(Proxy, WhatIsNotConnectedIsFartherThanAllElseAndNotInfinitelyFar) {
  const Proxy proxy = make_proxy(two_spheres(), true, false, {.nodes = 100}, {});
  EXPECT_TRUE(proxy.distances.allFinite());
  const std::vector<int> component = vertex_components(proxy.mesh);
  float longest = 0, shortest_between = std::numeric_limits<float>::infinity();
  for (int a = 0; a < proxy.num_measured(); ++a) {
    for (int v = 0; v < proxy.num_vertices(); ++v) {
      const float distance = proxy.distances(a, v);
      if (component[v] == component[proxy.nodes[a]])
        longest = std::max(longest, distance);
      else
        shortest_between = std::min(shortest_between, distance);
    }
  }
  EXPECT_GT(longest, 0);
  EXPECT_TRUE(std::isfinite(shortest_between));
  EXPECT_GT(shortest_between, longest);
}

TEST(NodeGraph, HasACellForEachVertexOfTwoComponents) {
  const Proxy proxy = make_proxy(two_spheres(), true, false, {.nodes = 100}, {});
  const std::vector<int> component = vertex_components(proxy.mesh);
  const NodeGraph graph = node_graph(proxy, 100);
  ASSERT_EQ(std::ssize(graph.cell), proxy.num_vertices());
  for (int v = 0; v < proxy.num_vertices(); ++v) {
    ASSERT_GE(graph.cell[v], 0);
    EXPECT_EQ(component[v], component[proxy.nodes[graph.cell[v]]]);
  }
}

class ProxyOf : public testing::TestWithParam<test::ZooMesh> {};

TEST_P(ProxyOf, IsSound) {
  for (const ProxyOptions& options : {ProxyOptions{}, ProxyOptions{.vertices = 60, .nodes = 20}}) {
    const Prepared prepared(GetParam().mesh, options);
    expect_sound(prepared);
    expect_graph(prepared.proxy, 10);
    expect_graph(prepared.proxy, options.nodes);
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, ProxyOf, testing::ValuesIn(test::mesh_zoo()),
                         [](const auto& test) { return test.param.name; });

TEST(Proxy, OfATriangleAndOfATetrahedron) {
  const Mesh triangle{{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  for (const Mesh& mesh : {triangle, test::tetrahedron()}) {
    const Prepared prepared(mesh);
    expect_sound(prepared);
    EXPECT_EQ(prepared.proxy.num_nodes(), mesh.num_vertices());
    expect_graph(prepared.proxy, 2);
    expect_graph(prepared.proxy, 10);
  }
}

}  // namespace
}  // namespace isomatch::tracked
