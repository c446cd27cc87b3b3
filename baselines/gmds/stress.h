// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"
#include "shape/metric_surface.h"

namespace isomatch::baselines {

/// All distances between the vertices of a shape, relative to the largest.
class DistanceTable {
 public:
  DistanceTable(const MetricSurface& shape, const Context& context);

  double operator()(int a, int b) const { return values_[static_cast<std::size_t>(a) * n_ + b]; }
  /// Between points on triangles, linear in the weights of either.
  double operator()(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b) const;

 private:
  std::size_t n_;
  std::vector<float> values_;
};

/// The generalised stress of points on a target, against distances between source points.
class Stress {
 public:
  /// `wanted` holds the distances between the source points, relative to the largest geodesic; as
  /// many of its first rows count as there are points.
  Stress(const MetricSurface& target, const DistanceTable& distances,
         const Eigen::MatrixXd& wanted);

  /// The sum of squared differences over all pairs.
  double total(const SurfaceMap& points) const;

  /// A target vertex as a point on a triangle.
  SurfacePoint at_vertex(int vertex) const;

  /// The place of point `moving` of least stress with all others where they are, among all target
  /// vertices.
  SurfacePoint best_vertex(const SurfaceMap& points, int moving) const;

  /// Moves point `moving` to the least stress on its triangle, then on to neighbouring triangles as
  /// long as that lowers it.
  void improve(SurfaceMap& points, int moving) const;

 private:
  struct Place;

  /// Distances of the corners of `face` (columns) from all points but `moving`, minus the wanted
  /// ones.
  Eigen::MatrixX3d corner_distances(const SurfaceMap& points, int moving, int face) const;
  Place best_on_face(const SurfaceMap& points, int moving, int face) const;

  const MetricSurface& target_;
  const DistanceTable& distances_;
  const Eigen::MatrixXd& wanted_;
  IndexLists faces_of_vertex_;
};

}  // namespace isomatch::baselines
