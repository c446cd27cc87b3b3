// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "elastic/registration.h"
#include "isomatch/context.h"
#include "spectral/eigenbasis.h"
#include "spectral/spectral_map.h"
#include "tracked/options.h"
#include "tracked/shape/pyramid.h"

namespace isomatch::tracked {

/// Gives points outside the anchors to which the motion of the points inside around them takes
/// them.
void carry_outside(const elastic::PointCloud& cloud, std::vector<Point>& anchors);

/// Points of a registered cloud that have a counterpart: those that met the surface, inside before
/// or beside a point that was. Smoothed over the graph, without small pieces.
std::vector<bool> inside_after(const elastic::PointCloud& cloud, const IndexLists& neighbours,
                               const elastic::Registration& registration, const Options& options);

/// The same of any points with their areas.
std::vector<bool> smoothed(const std::vector<bool>& inside, const std::vector<double>& areas,
                           const IndexLists& neighbours, const PartialOptions& options);

/// Nodes of a shape of which some are left out.
struct Coverage {
  const std::vector<bool>& inside;
  /// Whether what is closest on the other shape is at its rim.
  const std::vector<bool>& by_rim;
  const std::vector<double>& areas;
  const IndexLists& neighbours;
};

/// The area of the nodes that are not inside. A piece counts more, the less of its border is by the
/// rim of the other shape, beyond which its counterpart may be what is missing.
double left_out(const Coverage& nodes, const PartialOptions& options);

/// Whether each foot is by the rim of the proxy that it is on.
std::vector<bool> feet_by_rim(const elastic::Registration& registration, const Proxy& target,
                              const PartialOptions& options);

/// A part of a proxy, with eigenfunctions of its own.
struct Part {
  spectral::Eigenbasis basis;
  /// Vertex of the proxy of each row, and the row of each vertex, `kNoVertex` where it has none.
  std::vector<int> vertex, row;

  bool empty() const { return vertex.empty(); }
};

/// The faces all of whose vertices are in cells of nodes `inside`, with at most so many
/// eigenfunctions. Empty if it is too small to have any.
Part part_of_proxy(const Proxy& proxy, const Level& level, const std::vector<bool>& inside,
                   int functions, const Context& context);

/// The parts of two shapes that overlap.
struct Overlap {
  Part source, target;
  /// Of the source's part.
  double area = 0;
};

/// A map between the nodes of two levels, and which of the nodes are inside.
struct NodeMap {
  const Level& source;
  const Level& target;
  const std::vector<bool>& source_inside;
  /// For each source node a vertex of the target's proxy, for each target node a source node.
  const std::vector<int>& vertices;
  const std::vector<int>& nearest;
};

/// `spectral::refine` on the parts alone. For the nodes of `wanted` vertices of the target's proxy;
/// `kNoVertex` for those that are not in the part.
std::vector<int> refine_on_overlap(const Overlap& overlap, const Proxy& source, const Proxy& target,
                                   const NodeMap& map, const Level& wanted, int size,
                                   const Context& context);

}  // namespace isomatch::tracked
