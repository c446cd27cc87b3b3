// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "elastic/registration.h"
#include "isomatch/context.h"
#include "isomatch/shape.h"
#include "isomatch/topology.h"

namespace isomatch::tracked {

using FloatMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct ProxyOptions {
  /// Vertices and nodes of the proxy, at most.
  int vertices = 3000;
  int nodes = 1200;
};

/// A surface scaled to unit area and centred, with normals. Faces are turned outwards if
/// `oriented`.
struct UnitSurface {
  Mesh mesh;
  /// Coordinates of the shape are `scale` times those of `mesh` plus `centre`.
  double scale = 1;
  Point centre{0, 0, 0};
  IndexLists faces;
  /// Whether it is known which side is outside.
  bool oriented = false;
  /// For each face whether its corners 1 and 2 were exchanged to turn it outwards.
  std::vector<bool> turned;
  /// Area-weighted unit normals of the vertices.
  std::vector<Point> normals;
  /// Of the vertices; places refer to the first nodes of the proxy.
  std::vector<elastic::Features> features;
};

/// `mirrored` reflects the coordinates first.
UnitSurface unit_surface(const Shape& shape, bool mirrored = false);

/// A simplified copy of a surface, scaled to unit area, on which everything global is computed, and
/// nodes spread evenly over it. Nodes come in farthest point order, so the first k of them are
/// evenly spread as well.
struct Proxy {
  /// Its vertices are a subset of the surface's. Faces are turned outwards if `oriented`.
  Mesh mesh;
  std::vector<int> surface_vertex;
  IndexLists faces;
  /// Whether it is known which side is outside.
  bool oriented = false;
  /// Area-weighted unit normals of the vertices.
  std::vector<Point> normals;
  /// Of the vertices; places refer to the first nodes.
  std::vector<elastic::Features> features;
  /// Proxy vertex of each node.
  std::vector<int> nodes;
  /// Geodesic distances from the nodes (rows) to all vertices (columns).
  FloatMatrix distances;

  int num_vertices() const { return mesh.num_vertices(); }
  int num_nodes() const { return static_cast<int>(nodes.size()); }
  const Point& node_position(int node) const { return mesh.vertices[nodes[node]]; }
  const Point& node_normal(int node) const { return normals[nodes[node]]; }
  float node_distance(int a, int b) const { return distances(a, nodes[b]); }
};

/// The first `count` nodes of a proxy as a graph.
struct NodeGraph {
  elastic::PointCloud cloud;
  /// For each node those whose Voronoi cells touch its own, ascending.
  IndexLists neighbours;
};

/// O(count * vertices).
NodeGraph node_graph(const Proxy& proxy, int count);

/// O(N log N + nodes * vertices log vertices).
Proxy make_proxy(const UnitSurface& surface, const ProxyOptions& options, const Context& context);

}  // namespace isomatch::tracked
