// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "isomatch/mesh/synth.h"
#include "tracked/hypotheses/local_shape.h"
#include "unit/tracked/cut.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

/// Two parts of a creature that share the fifth between them, in one coordinate system.
class Overlapping : public testing::Test {
 protected:
  struct Side {
    explicit Side(const Mesh& mesh, int count)
        : prepared(mesh, {}, {}, true), landmarks(prepared.proxy, first(count)) {}

    static std::vector<int> first(int count) {
      std::vector<int> nodes(count);
      std::iota(nodes.begin(), nodes.end(), 0);
      return nodes;
    }
    FloatMatrix shapes() const { return local_shapes(prepared.proxy, first(landmarks.size()), {}); }
    Point place(int landmark) const {
      return prepared.proxy.node_position(landmarks.node(landmark)) * prepared.surface.scale +
             prepared.surface.centre;
    }

    test::Prepared prepared;
    NodeDirections landmarks;
  };

  static Mesh upside_down(Mesh mesh) {
    for (Point& p : mesh.vertices) p = -p;
    return mesh;
  }

  std::vector<Correspondence> clusters() const {
    return agreeing_clusters(source_.landmarks, source_.shapes(), target_.landmarks,
                             target_.shapes(), {}, {});
  }

  const Mesh creature_ = synthesize({.vertices = 2500, .pose = 1}).mesh;
  const Side source_{test::cut(creature_, 2, 0.4), 60};
  const Side target_{upside_down(test::cut(upside_down(creature_), 2, 0.4)), 150};
};

TEST_F(Overlapping, PartsHaveAClusterWhereTheyAreTheSame) {
  const std::vector<Correspondence> found = clusters();
  ASSERT_FALSE(found.empty());
  const double reach = 0.1 * std::sqrt(surface_area(creature_));
  const auto is_right = [&](const Correspondence& matches) {
    return matches.size() >= 8 && std::ranges::all_of(matches, [&](const Match& match) {
             return (source_.place(match.source) - target_.place(match.target)).norm() < reach;
           });
  };
  EXPECT_TRUE(std::ranges::any_of(found, is_right));
}

TEST_F(Overlapping, PartsHaveClustersOfMatchesThatAgree) {
  const LocalShapeOptions options;
  for (const Correspondence& matches : clusters()) {
    std::set<int> sources, targets;
    for (std::size_t k = 0; k < matches.size(); ++k) {
      EXPECT_TRUE(sources.insert(matches[k].source).second);
      EXPECT_TRUE(targets.insert(matches[k].target).second);
      float sum = 0;
      for (std::size_t j = 0; j < k; ++j) {
        const float d =
            doubted_difference(source_.landmarks, {matches[k].source, matches[j].source},
                               target_.landmarks, {matches[k].target, matches[j].target},
                               options.doubt) /
            options.tolerable_difference;
        sum += std::max(0.0F, 1 - d * d);
      }
      EXPECT_GE(sum, 0.999F * options.least_agreement * static_cast<float>(k));
    }
  }
}

}  // namespace
}  // namespace isomatch::tracked
