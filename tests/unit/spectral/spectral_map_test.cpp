// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/spectral_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "isomatch/mesh/topology.h"
#include "support/context.h"
#include "support/random.h"
#include "support/transforms.h"

namespace isomatch::spectral {
namespace {

constexpr int kFunctions = 60;

/// A mesh with all of its vertices as samples.
struct Model {
  explicit Model(Mesh input)
      : mesh(std::move(input)), faces(vertex_faces(mesh)), basis(eigenbasis(mesh, kFunctions)) {
    samples.functions = basis.functions;
    samples.areas.resize(mesh.num_vertices());
    const std::vector<double> areas = vertex_areas(mesh);
    for (int v = 0; v < mesh.num_vertices(); ++v) samples.areas[v] = static_cast<float>(areas[v]);
  }

  Mesh mesh;
  IndexLists faces;
  Eigenbasis basis;
  Samples samples;
};

/// For each of `count` target vertices the source sample whose image is nearest.
std::vector<int> inverse(const Mesh& target, const std::vector<int>& map, int count) {
  std::vector<int> samples(map.size());
  std::iota(samples.begin(), samples.end(), 0);
  std::vector<int> result;
  for (int v = 0; v < count; ++v)
    result.push_back(*std::ranges::min_element(samples, {}, [&](int s) {
      return (target.vertices[map[s]] - target.vertices[v]).squaredNorm();
    }));
  return result;
}

/// `map` after one step with all functions.
std::vector<int> refined(const Model& source, const Model& target, const std::vector<int>& map) {
  return refine(source.samples, target.samples, target.basis,
                {map, inverse(target.mesh, map, target.mesh.num_vertices())}, source.samples,
                kFunctions, {});
}

std::vector<int> identity(const Mesh& mesh) {
  std::vector<int> map(mesh.vertices.size());
  std::iota(map.begin(), map.end(), 0);
  return map;
}

/// Every vertex goes to a corner of a random face around it.
std::vector<int> jittered(const Mesh& mesh, const IndexLists& faces, test::Random& random) {
  std::vector<int> map;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    const int face = faces[v][random.index(static_cast<int>(faces[v].size()))];
    map.push_back(mesh.faces[face][random.index(3)]);
  }
  return map;
}

double mean_distance(const Mesh& mesh, const std::vector<int>& a, const std::vector<int>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (mesh.vertices[a[i]] - mesh.vertices[b[i]]).norm();
  return sum / static_cast<double>(a.size());
}

class SpectralMap : public testing::Test {
 protected:
  const Model model_{synthesize({.vertices = 1000, .pose = 1}).mesh};
};

TEST_F(SpectralMap, IdentityStays) {
  const std::vector<int> map = identity(model_.mesh);
  EXPECT_EQ(refined(model_, model_, map), map);
}

TEST_F(SpectralMap, RelabellingStays) {
  test::Random random(1);
  const test::Relabelled copy = test::relabelled(model_.mesh, random);
  EXPECT_EQ(refined(model_, Model(copy.mesh), copy.new_vertex), copy.new_vertex);
}

TEST_F(SpectralMap, JitterGoes) {
  test::Random random(1);
  const std::vector<int> right = identity(model_.mesh);
  const std::vector<int> map = jittered(model_.mesh, model_.faces, random);
  EXPECT_LT(mean_distance(model_.mesh, refined(model_, model_, map), right),
            0.3 * mean_distance(model_.mesh, map, right));
}

TEST_F(SpectralMap, IdentityOfSomeSamplesGivesThatOfAll) {
  constexpr int kSamples = 300;  // At random places, for synthesized vertices have a random order.
  const auto area = static_cast<float>(surface_area(model_.mesh) / kSamples);
  const Samples samples{model_.basis.functions.topRows(kSamples),
                        Eigen::VectorXf::Constant(kSamples, area)};
  std::vector<int> map(kSamples);
  std::iota(map.begin(), map.end(), 0);
  const std::vector<int> result =
      refine(samples, samples, model_.basis, {map, map}, model_.samples, 20, {});
  EXPECT_LT(mean_distance(model_.mesh, result, identity(model_.mesh)), 0.1);
}

TEST_F(SpectralMap, BothDirectionsCount) {
  test::Random random(3);
  const std::vector<int> right = identity(model_.mesh);
  const std::vector<int> jitter = jittered(model_.mesh, model_.faces, random);
  const auto error = [&](const TwoWayMap& map) {
    return mean_distance(
        model_.mesh,
        refine(model_.samples, model_.samples, model_.basis, map, model_.samples, kFunctions, {}),
        right);
  };
  EXPECT_LT(error({jitter, right}), error({jitter, jitter}));
  EXPECT_LT(error({right, jitter}), error({jitter, jitter}));
}

TEST(SpectralMapOfATetrahedron, Stays) {
  const Model model(
      {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
  const std::vector<int> map = identity(model.mesh);
  EXPECT_EQ(refined(model, model, map), map);
}

}  // namespace
}  // namespace isomatch::spectral
