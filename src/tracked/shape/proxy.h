// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <vector>

#include "elastic/registration.h"
#include "isomatch/context.h"
#include "isomatch/mesh/topology.h"
#include "shape/memo.h"
#include "tracked/options.h"
#include "tracked/shape/detail.h"
#include "tracked/shape/second_form.h"

namespace isomatch::tracked {

using FloatMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Second fundamental forms at the vertices, by the length over which they are averaged.
using KeptForms = Memo<double, std::vector<SecondForm>>;

/// A simplified copy of a surface, on which everything global is computed, and
/// nodes spread evenly over it. Nodes come in farthest point order, so the first k of them are
/// evenly spread as well.
struct Proxy {
  /// Its vertices are a subset of the detail's. Faces are turned outwards if `oriented`.
  Mesh mesh;
  std::vector<int> detail_vertex;
  IndexLists faces;
  /// Whether it is known which side is outside.
  bool oriented = false;
  /// Area-weighted unit normals of the vertices.
  std::vector<Point> normals;
  /// Of the vertices; places refer to the first nodes.
  std::vector<elastic::Features> features;
  /// Proxy vertex of each node.
  std::vector<int> nodes;
  std::shared_ptr<const GeodesicGraph> graph;
  /// Geodesic distances from the first nodes (rows) to all vertices (columns).
  FloatMatrix distances;
  /// Of the vertices from the boundary; infinite where nothing is missing.
  std::vector<float> to_boundary;
  /// What `second_forms_of` has made: only proxies on which images slide need it. Copies share it:
  /// who changes the mesh of a copy gives it one of its own.
  std::shared_ptr<KeptForms> kept_forms = std::make_shared<KeptForms>();

  int num_vertices() const { return mesh.num_vertices(); }
  int num_nodes() const { return static_cast<int>(nodes.size()); }
  int num_measured() const { return static_cast<int>(distances.rows()); }
  const Point& node_position(int node) const { return mesh.vertices[nodes[node]]; }
  const Point& node_normal(int node) const { return normals[nodes[node]]; }
  /// Of a node from which distances are measured to any node.
  float node_distance(int a, int b) const { return distances(a, nodes[b]); }
  /// What that distance is at least on the shape that this one is a part of: what is shorter than
  /// the ways to the boundary leads through nothing that is missing.
  float least_distance(int a, int b) const {
    return std::min(node_distance(a, b), to_boundary[nodes[a]] + to_boundary[nodes[b]]);
  }
};

/// How a proxy curves at its vertices, averaged over `length`, see `second_forms`; made once, also
/// where threads share the proxy.
std::shared_ptr<const std::vector<SecondForm>> second_forms_of(const Proxy& proxy, double length);

/// The first `count` nodes of a proxy as a graph.
struct NodeGraph {
  elastic::PointCloud cloud;
  /// Of each vertex of the proxy the node in whose Voronoi cell it lies.
  std::vector<int> cell;
  /// For each node those whose Voronoi cells touch its own, ascending.
  IndexLists neighbours;
};

/// O(N log N).
NodeGraph node_graph(const Proxy& proxy, int count);

/// `oriented` as the surface is; `open` if something may be missing beyond its boundary.
/// O(N log N + measured nodes * vertices log vertices).
Proxy make_proxy(const Detail& detail, bool oriented, bool open, const ProxyOptions& options,
                 const Context& context);

}  // namespace isomatch::tracked
