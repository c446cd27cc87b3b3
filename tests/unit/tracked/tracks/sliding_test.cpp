// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/sliding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "geometry/closest_point.h"
#include "geometry/walk.h"
#include "isomatch/mesh/synth.h"
#include "support/random.h"
#include "support/shapes.h"
#include "unit/tracked/prepared.h"

namespace isomatch::tracked {
namespace {

using test::Prepared;

const Prepared& creature() {
  static const Prepared prepared(synthesize({.vertices = 4000, .pose = 1}).mesh);
  return prepared;
}

/// Of the vertices from where they lie when nothing slid.
double mean_error(const Proxy& proxy, const SurfaceMap& images, const std::vector<bool>& which) {
  double sum = 0;
  int count = 0;
  for (int v = 0; v < proxy.num_vertices(); ++v) {
    if (!which.empty() && !which[v]) continue;
    sum += (position(proxy.mesh, images[v]) - proxy.mesh.vertices[v]).norm();
    ++count;
  }
  return sum / count;
}

/// The vertices, each moved along the surface by as much as `move` says.
template <class Move>
SurfaceMap moved(const Proxy& proxy, const Move& move) {
  SurfaceMap images;
  for (int v = 0; v < proxy.num_vertices(); ++v) {
    const Point p = proxy.mesh.vertices[v] + move(proxy.mesh.vertices[v]);
    images.push_back(closest_point_around(proxy.mesh, proxy.faces,
                                          walk_to_vertex(proxy.mesh, proxy.faces, v, p), p));
  }
  return images;
}

SurfaceMap shifted(const Proxy& proxy) {
  return moved(proxy, [](const Point& p) {
    return Point(0.01 * std::sin(5 * p.y()), 0.01 * std::cos(5 * p.x()), 0.01);
  });
}

TEST(Sliding, LeavesTheIdentityAlone) {
  const Proxy& proxy = creature().proxy;
  const SurfaceMap slid_images = slid(proxy, proxy, corner_points(proxy.mesh), {}, {});
  EXPECT_LT(mean_error(proxy, slid_images, {}), 1e-4);
}

TEST(Sliding, BringsShiftedImagesBackToWhereTheSurfaceCurvesAlike) {
  const Proxy& proxy = creature().proxy;
  const SurfaceMap images = shifted(proxy);
  const double before = mean_error(proxy, images, {});
  EXPECT_GT(before, 0.007);
  EXPECT_LT(mean_error(proxy, slid(proxy, proxy, images, {}, {}), {}), 0.5 * before);
}

TEST(Sliding, WorksTheSameWhereverTheTargetIsTurned) {
  const Proxy& proxy = creature().proxy;
  Proxy turned = proxy;
  const Eigen::Matrix3d rotation = test::Random(3).rotation();
  for (Point& p : turned.mesh.vertices) p = rotation * p;
  for (Point& n : turned.normals) n = rotation * n;
  turned.kept_forms = std::make_shared<KeptForms>();
  const SurfaceMap images = shifted(proxy);
  const SurfaceMap here = slid(proxy, proxy, images, {}, {}),
                   there = slid(proxy, turned, images, {}, {});
  for (std::size_t v = 0; v < images.size(); ++v)
    EXPECT_LT((rotation * position(proxy.mesh, here[v]) - position(turned.mesh, there[v])).norm(),
              2e-3);
}

TEST(Sliding, WhatIsOutsideFollowsAndPullsNothing) {
  const Proxy& proxy = creature().proxy;
  std::vector<bool> inside;
  for (const Point& p : proxy.mesh.vertices) inside.push_back(p.x() > 0);
  // What is outside lies far from where it belongs: that must not disturb what is inside.
  const SurfaceMap images = moved(
      proxy, [](const Point& p) { return p.x() > 0 ? Point(0, 0, 0) : Point(0, 0.02, 0.02); });
  const SurfaceMap after = slid(proxy, proxy, images, inside, {});
  EXPECT_LT(mean_error(proxy, after, inside), 2e-3);
}

TEST(Sliding, ASphereCurvesAlikeEverywhereSoNothingIsTorn) {
  const Prepared sphere(test::icosphere(4));
  const SurfaceMap images = shifted(sphere.proxy);
  const SurfaceMap after = slid(sphere.proxy, sphere.proxy, images, {}, {});
  for (std::size_t v = 0; v < images.size(); ++v)
    EXPECT_LT(
        (position(sphere.proxy.mesh, after[v]) - position(sphere.proxy.mesh, images[v])).norm(),
        0.1);
}

}  // namespace
}  // namespace isomatch::tracked
