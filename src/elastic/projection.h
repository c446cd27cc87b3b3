// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "elastic/nearest_point.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::elastic {

/// A point of a mesh, where it lies, and the normal there.
struct Foot {
  SurfacePoint point;
  Point position{0, 0, 0};
  Point normal{0, 0, 0};
  /// Whether it lies on the rim of the mesh.
  bool on_rim = false;
};

/// Finds the points of a mesh that are closest in position and normal.
class Projection {
 public:
  /// Keeps references, but not `rim`: the vertices beyond which something may be missing.
  Projection(const Mesh& mesh, const IndexLists& vertex_faces, const std::vector<Point>& normals,
             const std::vector<Features>& features, const ProjectionWeights& weights,
             std::span<const int> rim = {});

  /// The closest point on the faces around the vertex that is closest in position, normal and
  /// features.
  Foot operator()(const Point& position, const Point& normal, const Features& features) const;
  /// The same, found sooner if it is near an earlier foot.
  Foot operator()(const Point& position, const Point& normal, const Features& features,
                  const SurfacePoint& earlier) const;

 private:
  const Mesh& mesh_;
  const IndexLists& vertex_faces_;
  const std::vector<Point>& normals_;
  NearestPoint nearest_vertex_;
  std::vector<bool> on_rim_;
};

}  // namespace isomatch::elastic
