// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "support/random.h"

namespace isomatch::test {
namespace {

constexpr double kPi = std::numbers::pi;

Mesh icosahedron() {
  const double t = std::numbers::phi;
  return {{Point(-1, t, 0), Point(1, t, 0), Point(-1, -t, 0), Point(1, -t, 0), Point(0, -1, t),
           Point(0, 1, t), Point(0, -1, -t), Point(0, 1, -t), Point(t, 0, -1), Point(t, 0, 1),
           Point(-t, 0, -1), Point(-t, 0, 1)},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Splits each triangle into four.
Mesh subdivided(const Mesh& mesh) {
  Mesh result{mesh.vertices, {}};
  std::map<std::pair<int, int>, int> middle;
  const auto middle_of = [&](int a, int b) {
    const auto [place, is_new] = middle.try_emplace(std::minmax(a, b), result.num_vertices());
    if (is_new) result.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    return place->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const int ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    for (const Face& face : {Face{a, ab, ca}, Face{b, bc, ab}, Face{c, ca, bc}, Face{ab, bc, ca}})
      result.faces.push_back(face);
  }
  return result;
}

/// Two triangles for the cell whose corners are given in cyclic order.
void add_quad(Mesh& mesh, int a, int b, int c, int d) {
  mesh.faces.push_back({a, b, c});
  mesh.faces.push_back({a, c, d});
}

/// Joins a grid of vertices, numbered row by row. A grid that wraps has as many vertices along that
/// side as cells, otherwise one more.
void add_grid_faces(Mesh& mesh, int columns, int rows, bool wrap_columns, bool wrap_rows) {
  const int width = wrap_columns ? columns : columns + 1;
  const int height = wrap_rows ? rows : rows + 1;
  const auto number = [&](int i, int j) { return (j % height) * width + i % width; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i)
      add_quad(mesh, number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1));
  }
}

/// The point at `part` of `parts` of the unit circle; all the way round is exactly the start.
Eigen::Vector2d on_circle(int part, int parts) {
  const double angle = 2 * kPi * (part % parts) / parts;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Mesh icosphere(int subdivisions, double radius) {
  Mesh mesh = icosahedron();
  for (int i = 0; i < subdivisions; ++i) {
    for (Point& p : mesh.vertices) p.normalize();
    mesh = subdivided(mesh);
  }
  for (Point& p : mesh.vertices) p *= radius / p.norm();
  return mesh;
}

Mesh rough_sphere(int subdivisions, double roughness, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh = icosphere(subdivisions);
  for (Point& p : mesh.vertices) p *= random.uniform(1 - roughness, 1 + roughness);
  return mesh;
}

Mesh uv_sphere(int columns, int rows, double radius) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    const bool is_pole = j == 0 || j == rows;
    const double r = is_pole ? 0 : std::sin(kPi * j / rows), z = -std::cos(kPi * j / rows);
    for (int i = 0; i <= columns; ++i) {
      const Eigen::Vector2d xy = r * on_circle(i, columns);
      mesh.vertices.push_back(radius * Point(xy.x(), xy.y(), z));
    }
  }
  add_grid_faces(mesh, columns, rows, false, false);
  return mesh;
}

Mesh lump(int number) {
  Mesh mesh = icosphere(2);
  const Point top = Point(2, 3, 2).normalized();
  for (Point& p : mesh.vertices) {
    const double bump = 1 + 0.25 * std::exp(-3 * (p - top).squaredNorm());
    p = bump * p.cwiseProduct(Point(1 + 0.07 * number, 0.7 - 0.04 * number, 0.4));
  }
  return mesh;
}

Mesh sheet(int columns, int rows, double width, double height) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i)
      mesh.vertices.emplace_back(width * i / columns, height * j / rows, 0);
  }
  add_grid_faces(mesh, columns, rows, false, false);
  return mesh;
}

Mesh rolled_sheet(int columns, int rows, double width, double height, double angle) {
  Mesh mesh = sheet(columns, rows, width, height);
  const double radius = width / angle;
  for (Point& p : mesh.vertices) {
    const double turn = p.x() / radius;
    p = Point(radius * std::sin(turn), p.y(), radius * (1 - std::cos(turn)));
  }
  return mesh;
}

Mesh open_cylinder(int segments, int rings, double radius, double height) {
  Mesh mesh;
  for (int j = 0; j <= rings; ++j) {
    for (int i = 0; i < segments; ++i) {
      const Eigen::Vector2d xy = radius * on_circle(i, segments);
      mesh.vertices.emplace_back(xy.x(), xy.y(), height * j / rings);
    }
  }
  add_grid_faces(mesh, segments, rings, true, false);
  return mesh;
}

Mesh closed_cylinder(int segments, int rings, double radius, double height) {
  Mesh mesh = open_cylinder(segments, rings, radius, height);
  const int bottom = mesh.num_vertices(), top = bottom + 1, last_ring = rings * segments;
  mesh.vertices.emplace_back(0, 0, 0);
  mesh.vertices.emplace_back(0, 0, height);
  for (int i = 0; i < segments; ++i) {
    const int next = (i + 1) % segments;
    mesh.faces.push_back({bottom, next, i});
    mesh.faces.push_back({top, last_ring + i, last_ring + next});
  }
  return mesh;
}

Mesh torus(int columns, int rows, double major_radius, double minor_radius) {
  Mesh mesh;
  for (int j = 0; j < rows; ++j) {
    const Eigen::Vector2d section = minor_radius * on_circle(j, rows);
    for (int i = 0; i < columns; ++i) {
      const Eigen::Vector2d xy = (major_radius + section.x()) * on_circle(i, columns);
      mesh.vertices.emplace_back(xy.x(), xy.y(), section.y());
    }
  }
  add_grid_faces(mesh, columns, rows, true, true);
  return mesh;
}

Mesh box(int cells, const Point& size) {
  Mesh mesh;
  std::map<std::array<int, 3>, int> number;
  const auto vertex = [&](const std::array<int, 3>& cell) {
    const auto [place, is_new] = number.try_emplace(cell, mesh.num_vertices());
    const Point p = Point(cell[0], cell[1], cell[2]) / cells;
    if (is_new) mesh.vertices.push_back(p.cwiseProduct(size));
    return place->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int side : {0, cells}) {
      const auto at = [&](int i, int j) {
        std::array<int, 3> cell;
        cell[axis] = side;
        cell[(axis + 1) % 3] = side == 0 ? j : i;
        cell[(axis + 2) % 3] = side == 0 ? i : j;
        return vertex(cell);
      };
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j)
          add_quad(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return mesh;
}

Mesh moebius_strip(int segments, double radius, double width) {
  Mesh mesh;
  for (int i = 0; i < segments; ++i) {
    const double turn = 2 * kPi * i / segments;
    for (double side : {-width / 2, width / 2}) {
      const double r = radius + side * std::cos(turn / 2);
      mesh.vertices.emplace_back(r * std::cos(turn), r * std::sin(turn), side * std::sin(turn / 2));
    }
  }
  for (int i = 0; i + 1 < segments; ++i) add_quad(mesh, 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2);
  const int last = 2 * segments - 2;
  add_quad(mesh, last, last + 1, 0, 1);
  return mesh;
}

}  // namespace isomatch::test
