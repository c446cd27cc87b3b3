// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/tangent_frame.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::tracked {

/// A tangent vector, in coordinates of a frame.
using Tangent = Eigen::Vector2d;
/// A tangent vector of each vertex.
using TangentField = std::vector<Tangent>;

/// What an energy does at a vertex: half its Hessian and its negative gradient.
struct Pull {
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
  Tangent force = Tangent::Zero();
};

/// Compares tangent vectors of neighbours: the connection Laplacian of a mesh (Singer and Wu 2012),
/// with cotangent weights.
class Connection {
 public:
  /// An edge as one of its ends sees it: the other end, its weight, and how that end's tangent
  /// vectors turn on their way here.
  struct Link {
    int to;
    double weight;
    Eigen::Matrix2d turn;
  };

  /// `normals` are of unit length. O(N).
  Connection(const Mesh& mesh, const std::vector<Point>& normals);

  const TangentFrame& frame(int vertex) const { return frames_[vertex]; }
  const std::vector<Link>& links(int vertex) const { return links_[vertex]; }

  /// The field that balances the pulls and being smooth, which counts `smoothness` times: by
  /// conjugate gradients, O(N) each of at most 60.
  TangentField balanced(const std::vector<Pull>& pulls, double smoothness) const;

 private:
  Eigen::Matrix2d transport(int from, int to, const std::vector<Point>& normals) const;
  std::vector<Eigen::Matrix2d> inverse_diagonal(const std::vector<Pull>& pulls,
                                                double smoothness) const;
  TangentField resistance(const std::vector<Pull>& pulls, double smoothness,
                          const TangentField& field) const;

  std::vector<TangentFrame> frames_;
  std::vector<std::vector<Link>> links_;
};

}  // namespace isomatch::tracked
