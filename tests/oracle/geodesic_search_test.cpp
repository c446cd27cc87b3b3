// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <ostream>
#include <queue>

#include "isomatch/geodesics/geodesics.h"
#include "support/rough_meshes.h"

namespace isomatch {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A torus with one vertex drawn out far beyond the rest.
Mesh spike() {
  Mesh mesh = test::jittered_torus(20, 10, 0.25, 7);
  mesh.vertices[50] *= 300;
  return mesh;
}

/// As a torus, but half of its vertices coincide with their neighbours.
Mesh collapsed() {
  Mesh mesh = test::jittered_torus(20, 10, 0.25, 8);
  for (int v = 0; v + 1 < mesh.num_vertices(); v += 2) mesh.vertices[v] = mesh.vertices[v + 1];
  return mesh;
}

struct Case {
  const char* name;
  Mesh (*make)();
  GeodesicOptions options;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

std::vector<float> plain_dijkstra(const GeodesicGraph& graph, int source) {
  using Item = std::pair<float, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::vector<float> distances(graph.num_vertices(), kInfinity);
  distances[source] = 0;
  queue.emplace(0.0F, source);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    for (const auto& arc : graph.arcs(v)) {
      if (d + arc.length >= distances[arc.head]) continue;
      distances[arc.head] = d + arc.length;
      queue.emplace(d + arc.length, arc.head);
    }
  }
  return distances;
}

class SearchAgainstPlain : public ::testing::TestWithParam<Case> {
 protected:
  SearchAgainstPlain() {
    for (int v = 0; v < graph_.num_vertices(); ++v) exact_.push_back(plain_dijkstra(graph_, v));
  }

  /// The connected vertices within `radius` of `source`, in order.
  std::vector<std::pair<float, int>> expected_ball(int source, float radius) const {
    std::vector<std::pair<float, int>> ball;
    for (int v = 0; v < graph_.num_vertices(); ++v)
      if (exact_[source][v] <= radius && exact_[source][v] < kInfinity)
        ball.emplace_back(exact_[source][v], v);
    std::ranges::sort(ball);
    return ball;
  }

  std::vector<std::pair<float, int>> found_ball(int source, float radius) {
    std::vector<std::pair<float, int>> ball;
    for (const auto& [v, distance] : search_.ball(source, radius)) ball.emplace_back(distance, v);
    return ball;
  }

  GeodesicGraph graph_{GetParam().make(), GetParam().options};
  GeodesicSearch search_{graph_};
  std::vector<std::vector<float>> exact_;
};

TEST_P(SearchAgainstPlain, FieldsAreTheSame) {
  std::vector<float> field(graph_.num_vertices());
  for (int v = 0; v < graph_.num_vertices(); ++v) {
    search_.field(v, field);
    ASSERT_EQ(field, exact_[v]) << "from vertex " << v;
  }
}

TEST_P(SearchAgainstPlain, FloydAndWarshallAgree) {
  const int n = graph_.num_vertices();
  std::vector<std::vector<double>> distances(n, std::vector<double>(n, kInfinity));
  for (int v = 0; v < n; ++v) {
    distances[v][v] = 0;
    for (const auto& arc : graph_.arcs(v)) distances[v][arc.head] = arc.length;
  }
  for (int via = 0; via < n; ++via) {
    for (int a = 0; a < n; ++a) {
      for (int b = 0; b < n; ++b)
        distances[a][b] = std::min(distances[a][b], distances[a][via] + distances[via][b]);
    }
  }
  std::vector<float> field(n);
  for (int a = 0; a < n; a += 13) {
    search_.field(a, field);
    // Sums of up to a hundred floats.
    for (int b = 0; b < n; ++b) {
      if (field[b] != distances[a][b]) {
        ASSERT_NEAR(field[b] / distances[a][b], 1, 6e-6);
      }
    }
  }
}

TEST_P(SearchAgainstPlain, BallsAreCutFromFieldsInOrder) {
  for (int v = 0; v < graph_.num_vertices(); v += 7) {
    std::vector<float> radii = exact_[v];
    std::ranges::sort(radii);
    const std::size_t n = radii.size();
    for (const float radius : {0.0F, radii[5], radii[n / 3], radii[n / 2] * 1.001F, radii[n - 1]})
      ASSERT_EQ(found_ball(v, radius), expected_ball(v, radius)) << v << " radius " << radius;
  }
}

TEST_P(SearchAgainstPlain, DistancesAreThoseOfFields) {
  for (int a = 0; a < graph_.num_vertices(); a += 3) {
    for (int b = 0; b < graph_.num_vertices(); b += 5)
      ASSERT_EQ(search_.distance(a, b), exact_[a][b]) << a << " to " << b;
  }
}

TEST_P(SearchAgainstPlain, AddingSourcesTakesTheMinimumOfFields) {
  std::vector<float> field(graph_.num_vertices(), kInfinity), expected = field;
  for (const int source : {17, 3, 90, 3, 41, 150}) {
    search_.update_field(source, field);
    for (int v = 0; v < graph_.num_vertices(); ++v)
      expected[v] = std::min(expected[v], exact_[source][v]);
    ASSERT_EQ(field, expected);
  }
}

TEST_P(SearchAgainstPlain, NearestSourceIsTheFirstOfTheLeastFields) {
  const std::vector<int> sources{90, 17, 3, 18, 19, 3, 150, 151, 152};
  const SourcePartition partition = search_.nearest_source(sources);
  for (int v = 0; v < graph_.num_vertices(); ++v) {
    int nearest = kNoSource;
    float least = kInfinity;
    for (int i = 0; i < static_cast<int>(sources.size()); ++i) {
      if (exact_[sources[i]][v] < least) {
        least = exact_[sources[i]][v];
        nearest = i;
      }
    }
    ASSERT_EQ(partition.nearest[v], nearest) << v;
    ASSERT_EQ(partition.distances[v], least) << v;
  }
}

TEST_P(SearchAgainstPlain, ArcsAreSymmetricSortedAndWithoutLoops) {
  for (int v = 0; v < graph_.num_vertices(); ++v) {
    const auto arcs = graph_.arcs(v);
    ASSERT_TRUE(std::ranges::is_sorted(arcs, std::ranges::less_equal(), &GeodesicGraph::Arc::head));
    for (const auto& [head, length] : arcs) {
      ASSERT_NE(head, v);
      const auto back = graph_.arcs(head);
      const auto reverse = std::ranges::find(back, v, &GeodesicGraph::Arc::head);
      ASSERT_NE(reverse, back.end());
      ASSERT_EQ(reverse->length, length);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, SearchAgainstPlain,
    ::testing::Values(Case{"edges", [] { return test::jittered_torus(20, 10, 0.25, 1); },
                           GeodesicOptions::edges()},
                      Case{"visibility", [] { return test::rough_torus(20, 10, 0.1, 2); }, {}},
                      Case{"needles", [] { return test::jittered_torus(4, 50, 0.25, 3); }, {}},
                      Case{"slivers", [] { return test::sliver_torus(20, 10, 0.001, 4); }, {}},
                      Case{"bounded", [] { return test::holed_terrain(14, 0.03, 5); }, {}},
                      Case{"soup", [] { return test::triangle_soup(170, 100, 6); }, {}},
                      Case{"spike", spike, {}}, Case{"collapsed", collapsed, {}}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace isomatch
