// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "elastic/rows.h"
#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::elastic {

/// Where a point is pulled: onto a plane, and to an anchor.
struct Goal {
  Point foot{0, 0, 0};
  Point normal{0, 0, 0};
  double weight = 0;
  Point anchor{0, 0, 0};
  double anchor_weight = 0;
};

/// As-rigid-as-possible deformation of a graph of points on a surface (Sorkine and Alexa 2007) with
/// smooth rotations (Levi and Gotsman 2015). Lengths are in units of sqrt(area).
class Deformation {
 public:
  /// `neighbours` must be symmetric.
  Deformation(std::vector<Point> rest, IndexLists neighbours);
  Deformation(const Deformation& other);
  Deformation& operator=(const Deformation& other) { return *this = Deformation(other); }
  Deformation(Deformation&&) = default;
  Deformation& operator=(Deformation&&) = default;
  ~Deformation() = default;

  int size() const { return static_cast<int>(rest_.size()); }
  const IndexLists& neighbours() const { return neighbours_; }
  const std::vector<Point>& rest() const { return rest_; }
  const std::vector<Point>& positions() const { return positions_; }
  const std::vector<Eigen::Quaterniond>& rotations() const { return rotations_; }
  void set_positions(std::vector<Point> positions) { positions_ = std::move(positions); }

  /// The rotations that fit the positions best. `smoothness` weighs agreement with the rotations of
  /// the neighbours, 0 for none.
  void fit_rotations(double smoothness, const Context& context);
  /// Positions that minimise `stiffness` times the elastic energy plus the squared distances to
  /// `goals`, for fixed rotations. Every component of the graph needs a weight. Conjugate gradients
  /// from the present positions, preconditioned by the solution with goals of no direction, or with
  /// goals much like these.
  void fit_positions(std::span<const Goal> goals, double stiffness);
  /// Elastic energy at each point, an integrand over the surface with stiffness 1.
  std::vector<double> energies() const;

 private:
  Rows right_side(std::span<const Goal> goals, double stiffness) const;
  Rows gradient(std::span<const Goal> goals, double stiffness, const Rows& x) const;
  void precondition(std::span<const Goal> goals, double stiffness);

  std::vector<Point> rest_, positions_;
  std::vector<Eigen::Quaterniond> rotations_;
  IndexLists neighbours_;
  Eigen::SparseMatrix<double> system_;
  std::unique_ptr<Factors> solver_;
  /// What the factors are for; no weights if there are none yet.
  double factorised_stiffness_ = 0;
  std::vector<double> factorised_weights_;
};

}  // namespace isomatch::elastic
