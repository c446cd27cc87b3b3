// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/rough_meshes.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "support/random.h"

namespace isomatch::test {
namespace {

double symmetric(Random& random) { return random.uniform(-1, 1); }
bool coin(Random& random) { return random.index(2) == 1; }

void add_cell(std::vector<Face>& faces, std::array<int, 4> corners, bool turned) {
  const auto [a, b, c, d] = corners;
  if (turned) {
    faces.insert(faces.end(), {{a, b, d}, {b, c, d}});
  } else {
    faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
  }
}

/// The point of a torus at grid coordinates of `around` x `across` cells, `height` above it.
Point torus_point(double i, double j, int around, int across, double height) {
  const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
  const double r = 0.4 + height;
  const double ring = 1 + r * std::cos(v);
  return {ring * std::cos(u), ring * std::sin(u), r * std::sin(v)};
}

Mesh grid_torus(int around, int across, Random& random,
                const std::function<Point(int, int)>& point) {
  Mesh mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) mesh.vertices.push_back(point(i, j));
  const auto index = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j)
      add_cell(mesh.faces, {index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)},
               coin(random));
  }
  return mesh;
}

}  // namespace

Mesh jittered_torus(int around, int across, double jitter, std::uint64_t seed) {
  Random random(seed);
  return grid_torus(around, across, random, [&](int i, int j) {
    const double di = jitter * symmetric(random), dj = jitter * symmetric(random);
    return torus_point(i + di, j + dj, around, across, 0);
  });
}

Mesh rough_torus(int around, int across, double roughness, std::uint64_t seed) {
  Random random(seed);
  return grid_torus(around, across, random, [&](int i, int j) {
    return torus_point(i, j, around, across, roughness * symmetric(random));
  });
}

Mesh sliver_torus(int around, int across, double gap, std::uint64_t seed) {
  Random random(seed);
  return grid_torus(around, across, random, [&](int i, int j) {
    const bool moved = (i + j) % 3 == 0;
    return torus_point(moved ? i + 1 - gap * (2 + symmetric(random)) : i, j, around, across, 0);
  });
}

Mesh holed_terrain(int n, double bumpiness, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double x = (i + 0.3 * symmetric(random)) / (n - 1);
      const double y = (j + 0.3 * symmetric(random)) / (n - 1);
      mesh.vertices.emplace_back(x, y, bumpiness * symmetric(random));
    }
  }
  const auto in_hole = [](int i) { return i % 12 >= 5 && i % 12 < 9; };
  for (int i = 0; i + 1 < n; ++i) {
    for (int j = 0; j + 1 < n; ++j) {
      const int a = i * n + j;
      if (!in_hole(i) || !in_hole(j))
        add_cell(mesh.faces, {a, a + n, a + n + 1, a + 1}, coin(random));
    }
  }
  return mesh;
}

Mesh triangle_soup(int num_vertices, int num_faces, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int v = 0; v < num_vertices; ++v)
    mesh.vertices.emplace_back(symmetric(random), symmetric(random), symmetric(random));
  for (int f = 0; f < num_faces; ++f) {
    mesh.faces.push_back(
        {random.index(num_vertices), random.index(num_vertices), random.index(num_vertices)});
  }
  return mesh;
}

}  // namespace isomatch::test
