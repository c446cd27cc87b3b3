// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "isomatch/mesh.h"
#include "isomatch/topology.h"

namespace isomatch::elastic {

/// What tells points of a surface apart besides position and normal: how far they stand out at
/// several scales, and where on the surface they are, as distances along it from a few of its
/// points. The latter keep limbs apart that touch.
inline constexpr int kReliefs = 3;
inline constexpr int kPlaces = 5;
inline constexpr int kFeatures = kReliefs + kPlaces;
struct Features {
  std::array<double, kReliefs> relief{};
  std::array<double, kPlaces> place{};
};

/// How much other differences count, as distances.
struct ProjectionWeights {
  double normal = 0.2;
  double relief = 0.05;
  double place = 0;
};

/// A point on a triangle mesh.
struct Foot {
  int face = -1;
  std::array<double, 3> weights{};
  Point position{0, 0, 0};
  Point normal{0, 0, 0};
};

/// Finds the points of a mesh that are closest in position and normal.
class Projection {
 public:
  /// Keeps references.
  Projection(const Mesh& mesh, const IndexLists& vertex_faces, const std::vector<Point>& normals,
             const std::vector<Features>& features, const ProjectionWeights& weights);
  ~Projection();

  /// The vertex that is closest in position and normal.
  int nearest_vertex(const Point& position, const Point& normal, const Features& features) const;
  /// The closest point on the faces around that vertex.
  Foot operator()(const Point& position, const Point& normal, const Features& features) const;

 private:
  struct Index;

  Foot foot_at(int vertex) const;

  const Mesh& mesh_;
  const IndexLists& vertex_faces_;
  const std::vector<Point>& normals_;
  ProjectionWeights weights_;
  std::unique_ptr<Index> index_;
};

}  // namespace isomatch::elastic
