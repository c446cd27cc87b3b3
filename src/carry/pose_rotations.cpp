// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "carry/pose_rotations.h"

#include <cmath>

#include "geometry/rotation.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::transfer {
namespace {

struct EdgeSums {
  std::vector<Eigen::Matrix3d> covariances;
  double source_squares = 0, target_squares = 0;
};

/// Sums over the edges around each vertex both of whose ends are matched.
EdgeSums sum_edges(const Mesh& source, const Mesh& target, const SurfaceMap& target_to_source) {
  EdgeSums sums{std::vector<Eigen::Matrix3d>(target.vertices.size(), Eigen::Matrix3d::Zero())};
  for (const Face& face : target.faces) {
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      if (target_to_source[a].face == kNoFace || target_to_source[b].face == kNoFace) continue;
      const Point before =
          position(source, target_to_source[b]) - position(source, target_to_source[a]);
      const Point edge = target.vertices[b] - target.vertices[a];
      for (int v : {a, b}) sums.covariances[v] += before * edge.transpose();
      sums.source_squares += before.squaredNorm();
      sums.target_squares += edge.squaredNorm();
    }
  }
  return sums;
}

}  // namespace

RestPose fit_rest_pose(const Mesh& source, const Mesh& target, const SurfaceMap& target_to_source) {
  const EdgeSums sums = sum_edges(source, target, target_to_source);
  RestPose result;
  if (sums.source_squares > 0 && sums.target_squares > 0)
    result.scale = std::sqrt(sums.target_squares / sums.source_squares);
  std::vector<Eigen::Matrix3d> wide = sums.covariances;
  for (const auto& [a, b, c] : target.faces) {
    const Eigen::Matrix3d sum = sums.covariances[a] + sums.covariances[b] + sums.covariances[c];
    for (int v : {a, b, c}) wide[v] += sum;
  }
  result.rotations.reserve(target.faces.size());
  for (const auto& [a, b, c] : target.faces)
    result.rotations.push_back(best_rotation(wide[a] + wide[b] + wide[c]));
  return result;
}

}  // namespace isomatch::transfer
