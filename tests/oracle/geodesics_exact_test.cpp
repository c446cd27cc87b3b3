// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "exact_geodesics.h"
#include "isomatch/geodesics/geodesics.h"
#include "support/rough_meshes.h"

namespace isomatch {
namespace {

struct Case {
  const char* name;
  Mesh (*make)();
  double edges_error;  ///< Bound for mesh edges, which no accuracy is promised for.
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

struct RelativeErrors {
  double mean = 0, least = 0;
};

RelativeErrors errors_against(const std::vector<std::vector<double>>& exact,
                              const std::vector<int>& sources, const GeodesicGraph& graph) {
  RelativeErrors errors;
  int count = 0;
  const std::vector<float> fields = geodesic_fields(graph, sources);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (std::size_t v = 0; v < exact[i].size(); ++v) {
      const double distance = fields[i * exact[i].size() + v];
      EXPECT_EQ(std::isinf(distance), std::isinf(exact[i][v]));
      if (exact[i][v] == 0 || std::isinf(distance)) continue;
      const double error = distance / exact[i][v] - 1;
      errors.mean += error;
      errors.least = std::min(errors.least, error);
      ++count;
    }
  }
  errors.mean /= count;
  return errors;
}

class AgainstExact : public ::testing::TestWithParam<Case> {};

TEST_P(AgainstExact, MeanErrorsAreAsDocumentedAndNothingIsTooShort) {
  const Mesh mesh = GetParam().make();
  const std::vector<int> sources{0, mesh.num_vertices() / 3, mesh.num_vertices() - 1};
  std::vector<std::vector<double>> exact;
  exact.reserve(sources.size());
  for (const int s : sources) exact.push_back(test::exact_distances(mesh, s));

  const auto errors = [&](const GeodesicOptions& options) {
    return errors_against(exact, sources, GeodesicGraph(mesh, options));
  };
  const RelativeErrors edges = errors(GeodesicOptions::edges());
  const RelativeErrors w20 = errors(GeodesicOptions::w20());
  const RelativeErrors w10 = errors(GeodesicOptions::w10());
  EXPECT_GT(edges.mean, 0.03);
  EXPECT_LT(edges.mean, GetParam().edges_error);
  EXPECT_LT(w20.mean, 0.003);
  EXPECT_LT(w10.mean, 0.001);
  // A sum of fewer than a hundred floats is off by less than a hundred units of 6e-8.
  for (const RelativeErrors& e : {edges, w20, w10}) EXPECT_GT(e.least, -6e-6);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, AgainstExact,
    ::testing::Values(Case{"smooth", [] { return test::jittered_torus(50, 26, 0.25, 1); }, 0.1},
                      Case{"rough", [] { return test::rough_torus(50, 26, 0.04, 2); }, 0.1},
                      Case{"slivers", [] { return test::sliver_torus(50, 26, 0.02, 3); }, 0.1},
                      Case{"thin_slivers", [] { return test::sliver_torus(50, 26, 1e-4, 3); }, 0.1},
                      Case{"needles", [] { return test::jittered_torus(12, 120, 0.25, 4); }, 1.5},
                      Case{"bounded", [] { return test::holed_terrain(40, 0.01, 5); }, 0.1}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace isomatch
