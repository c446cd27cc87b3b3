// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>

#include "isomatch/mesh/mesh.h"

/// Shapes whose area, topology and geodesics are known. Closed shapes face outwards.
namespace isomatch::test {

/// A sphere about the origin: an icosahedron subdivided `subdivisions` times, 10 * 4^s + 2 vertices
/// and 20 * 4^s faces. Great circles are its geodesics up to the mesh's coarseness.
Mesh icosphere(int subdivisions, double radius = 1);

/// An icosphere whose vertices are moved along the radius by a factor uniform in
/// [1 - roughness, 1 + roughness): a rough, star-shaped surface of genus 0.
Mesh rough_sphere(int subdivisions, double roughness, std::uint64_t seed);

/// The sphere as modelling programs write it: `columns` times `rows` quads, a meridian and both
/// poles split for texture coordinates, (columns + 1)(rows + 1) vertices, and at each pole a
/// degenerate triangle a column.
Mesh uv_sphere(int columns, int rows, double radius = 1);

/// An ellipsoid with a bump, 162 vertices, of which the number decides the proportions: a shape
/// that is matched with others in a moment.
Mesh lump(int number);

/// A flat rectangle [0, width] x [0, height] of `columns` times `rows` cells, two triangles each.
/// Vertex (i, j) has number j (columns + 1) + i. Area width * height, geodesics straight lines.
Mesh sheet(int columns, int rows, double width = 1, double height = 1);

/// The sheet rolled isometrically onto a cylinder about the y axis so that it spans `angle`
/// radians. Its geodesics have the length of those of the flat sheet up to the mesh's coarseness.
Mesh rolled_sheet(int columns, int rows, double width, double height, double angle);

/// The side of a prism over a regular polygon of `segments` corners about the z axis, z from 0 to
/// `height`: area 2 segments radius sin(pi / segments) height, two boundary loops.
Mesh open_cylinder(int segments, int rings, double radius = 1, double height = 2);

/// The same closed by a fan at each end, which adds the area
/// segments radius^2 sin(2 pi / segments).
Mesh closed_cylinder(int segments, int rings, double radius = 1, double height = 2);

/// A torus about the z axis of `columns` times `rows` cells: genus 1.
Mesh torus(int columns, int rows, double major_radius = 2, double minor_radius = 1);

/// The surface of [0, size.x] x [0, size.y] x [0, size.z], each side of `cells` times `cells`
/// cells, vertices shared at the edges: 6 cells^2 + 2 vertices.
Mesh box(int cells, const Point& size = Point::Ones());

/// A Moebius strip of `segments` cells: not orientable, one boundary loop.
Mesh moebius_strip(int segments, double radius = 2, double width = 1);

}  // namespace isomatch::test
