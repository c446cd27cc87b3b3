// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <vector>

#include "elastic/projection.h"
#include "isomatch/context.h"
#include "isomatch/maps/correspondence.h"
#include "spectral/spectral_map.h"
#include "tracked/options.h"
#include "tracked/shape/contacts.h"
#include "tracked/shape/detail.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// The first so many nodes of a proxy.
struct Level {
  NodeGraph graph;
  spectral::Samples samples;

  int size() const { return static_cast<int>(graph.cloud.areas.size()); }
};

/// How a pair looks at a shape.
struct View {
  bool mirrored = false;
  /// sqrt(area), in the pair's unit of length: less than 1 where something is missing.
  double size = 1;
  /// Whether something may be missing beyond its boundary.
  bool open = false;
  /// Where parts that touch are taken apart.
  Cut cut = {};

  bool operator==(const View&) const = default;
};

/// A surface at decreasing density, with what is computed of it alone.
struct Pyramid {
  std::shared_ptr<const Surface> surface;
  Detail detail;
  /// For each vertex of the surface one of the detail that is close.
  std::vector<int> anchors;
  Proxy proxy;
  spectral::Eigenbasis basis;
  Level coarse, middle, fine;
  /// Of the surface the vertices beyond which something may be missing, ascending.
  std::vector<int> rim;
  View view;

  double area() const { return view.size * view.size; }
};

/// How often `make_pyramid` reports progress.
inline constexpr int kPyramidSteps = 5;

/// O(N log N).
Pyramid make_pyramid(const PreparedShape& shape, const View& view, const PyramidOptions& options,
                     const Context& context);

/// The same, made once and kept with the shape.
std::shared_ptr<const Pyramid> pyramid_of(const PreparedShape& shape, const View& view,
                                          const PyramidOptions& options, const Context& context);

/// Of the first `count` nodes the one that is closest in space.
int nearest_node(const Pyramid& pyramid, int surface_vertex, int count);

/// Vertices of the proxy.
std::vector<int> node_vertices(const Proxy& proxy, std::vector<int> nodes);

/// Those of `points` that are asked for, in that order.
std::vector<Point> selected(const std::vector<Point>& points, const std::vector<int>& indices);

/// The corners that are closest to points of a mesh.
std::vector<int> nearest_vertices(const Mesh& mesh, const std::vector<elastic::Foot>& feet);

/// Vertices beyond which something may be missing.
std::vector<int> rim_of(const Proxy& proxy);

elastic::Projection projection_onto(const Proxy& proxy, const elastic::ProjectionWeights& weights);

/// Notes on which vertex of the target each point is now.
void set_places(elastic::PointCloud& cloud, const Proxy& target, std::span<const int> vertices);

}  // namespace isomatch::tracked
