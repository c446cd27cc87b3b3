// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/deformation.h"

#include <cmath>

#include "isomatch/error.h"
#include "parallel.h"

namespace isomatch::elastic {
namespace {

/// Cotangent weight of an edge in a triangulation by equilateral triangles.
const double kEdgeWeight = 1 / std::sqrt(3.0);

/// The solution of a symmetric system, zero if it is not positive or nearly singular. By its
/// adjugate: that takes a quarter of the time of a decomposition.
Point solve_positive(const Eigen::Matrix3d& m, const Point& right) {
  constexpr double kSingular = 1e-3;  // Of the determinant of as large a multiple of the identity.
  const double mean = m.trace() / 3;
  const Point first = m.col(1).cross(m.col(2));
  const double minor = m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1), determinant = m.col(0).dot(first);
  if (m(0, 0) <= 0 || minor <= 0 || determinant <= kSingular * mean * mean * mean)
    return Point::Zero();
  return Point(first.dot(right), m.col(2).cross(m.col(0)).dot(right),
               m.col(0).cross(m.col(1)).dot(right)) /
         determinant;
}

/// Turns `rotation` to the rotation R closest to `m`, where tr(R^T m) is largest, by steps of
/// Newton's method; where its Hessian is not positive, by those of Mueller et al. 2016.
void extract_rotation(const Eigen::Matrix3d& m, Eigen::Quaterniond& rotation) {
  constexpr int kMaxIterations = 30;
  constexpr double kTolerance = 1e-3;  // Squared by the step that is made when it is reached.
  double angle = 1;
  for (int i = 0; i < kMaxIterations && angle > kTolerance; ++i) {
    const Eigen::Matrix3d s = m * rotation.toRotationMatrix().transpose();
    const Point gradient(s(2, 1) - s(1, 2), s(0, 2) - s(2, 0), s(1, 0) - s(0, 1));
    const double trace = s.trace();
    const Eigen::Matrix3d hessian = trace * Eigen::Matrix3d::Identity() - 0.5 * (s + s.transpose());
    Point turn = solve_positive(hessian, gradient);
    if (turn.isZero(0)) turn = gradient / (std::abs(trace) + 1e-12);
    angle = turn.norm();
    rotation = Eigen::Quaterniond(1, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()) * rotation;
    rotation.normalize();
  }
}

/// Half the gradient of a goal's energy, without its constant part and that part alone.
Point pull(const Goal& goal, const Point& x) {
  return goal.weight * goal.normal.dot(x) * goal.normal + goal.anchor_weight * x;
}
Point pull(const Goal& goal) {
  return goal.weight * goal.normal.dot(goal.foot) * goal.normal + goal.anchor_weight * goal.anchor;
}

}  // namespace

Deformation::Deformation(std::vector<Point> rest, IndexLists neighbours)
    : rest_(std::move(rest)),
      positions_(rest_),
      rotations_(rest_.size(), Eigen::Quaterniond::Identity()),
      neighbours_(std::move(neighbours)),
      system_(size(), size()),
      solver_(std::make_unique<Factors>()) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size(); ++i) {
    entries.emplace_back(i, i, kEdgeWeight * static_cast<double>(neighbours_[i].size()));
    for (int j : neighbours_[i]) entries.emplace_back(i, j, -kEdgeWeight);
  }
  system_.setFromTriplets(entries.begin(), entries.end());
  solver_->analyzePattern(system_);
}

Deformation::Deformation(const Deformation& other) : Deformation(other.rest_, other.neighbours_) {
  positions_ = other.positions_;
  rotations_ = other.rotations_;
}

void Deformation::fit_rotations(double smoothness, const Context& context) {
  std::vector<Eigen::Matrix3d> before(rotations_.size());
  double edge = 0;
  int count = 0;
  for (int i = 0; i < size(); ++i) {
    before[i] = rotations_[i].toRotationMatrix();
    for (int j : neighbours_[i]) edge += (rest_[i] - rest_[j]).squaredNorm(), ++count;
  }
  const double weight = smoothness * edge / count;
  parallel_for(size(), context, [&](std::ptrdiff_t k) {
    const int i = static_cast<int>(k);
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (int j : neighbours_[i]) {
      covariance += (positions_[i] - positions_[j]) * (rest_[i] - rest_[j]).transpose();
      covariance += weight * before[j];
    }
    extract_rotation(covariance, rotations_[i]);
  });
}

/// What the goals pull with, and what the rotations turn the edges to.
Rows Deformation::right_side(std::span<const Goal> goals, double stiffness) const {
  std::vector<Eigen::Matrix3d> rotations(rotations_.size());
  for (int i = 0; i < size(); ++i) rotations[i] = rotations_[i].toRotationMatrix();
  Rows right(size());
  for (int i = 0; i < size(); ++i) {
    Point sum = pull(goals[i]);
    for (int j : neighbours_[i])
      sum +=
          0.5 * stiffness * kEdgeWeight * ((rotations[i] + rotations[j]) * (rest_[i] - rest_[j]));
    right.set(i, sum);
  }
  return right;
}

/// Half the gradient of the energy that is minimised, without its constant part.
Rows Deformation::gradient(std::span<const Goal> goals, double stiffness, const Rows& x) const {
  Rows result(size());
  for (int i = 0; i < size(); ++i) {
    Rows::Row sum = static_cast<double>(neighbours_[i].size()) * x[i];
    for (int j : neighbours_[i]) sum -= x[j];
    result[i] = stiffness * kEdgeWeight * sum;
    result.add(i, pull(goals[i], x.point(i)));
  }
  return result;
}

/// Factorises the system as if goals had no direction, unless the last one is much the same.
void Deformation::precondition(std::span<const Goal> goals, double stiffness) {
  constexpr double kSame = 0.1;  // Then a few more iterations take less time than factors.
  std::vector<double> weights;
  for (const Goal& goal : goals) weights.push_back(goal.weight / 3 + goal.anchor_weight);
  if (stiffness == factorised_stiffness_ && !factorised_weights_.empty()) {
    double change = 0, sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      change += std::abs(weights[i] - factorised_weights_[i]);
      sum += weights[i];
    }
    if (change < kSame * sum) return;
  }
  factorised_weights_.clear();
  Eigen::SparseMatrix<double> isotropic = system_ * stiffness;
  for (int i = 0; i < size(); ++i) isotropic.coeffRef(i, i) += weights[i];
  solver_->factorize(isotropic);
  if (solver_->info() != Eigen::Success) throw SolverFailure("an elastic system is singular");
  factorised_stiffness_ = stiffness;
  factorised_weights_ = std::move(weights);
}

void Deformation::fit_positions(std::span<const Goal> goals, double stiffness) {
  constexpr int kMaxIterations = 40;
  constexpr double kTolerance = 1e-3;
  precondition(goals, stiffness);
  Rows x(size());
  for (int i = 0; i < size(); ++i) x.set(i, positions_[i]);
  Rows residual = right_side(goals, stiffness);
  residual.add_multiple(-1, gradient(goals, stiffness, x));
  Rows direction = solved(*solver_, residual);
  double rho = dot(residual, direction);
  const double enough = rho * kTolerance * kTolerance;
  for (int k = 0; k < kMaxIterations && rho > enough; ++k) {
    const Rows image = gradient(goals, stiffness, direction);
    const double step = rho / dot(direction, image);
    x.add_multiple(step, direction);
    residual.add_multiple(-step, image);
    Rows preconditioned = solved(*solver_, residual);
    const double next = dot(residual, preconditioned);
    preconditioned.add_multiple(next / rho, direction);
    direction = std::move(preconditioned);
    rho = next;
  }
  if (!std::isfinite(dot(x, x)))
    throw SolverFailure("an elastic deformation grows beyond all bounds");
  for (int i = 0; i < size(); ++i) positions_[i] = x.point(i);
}

std::vector<double> Deformation::energies() const {
  std::vector<double> energies(rest_.size(), 0.0);
  for (int i = 0; i < size(); ++i) {
    const Eigen::Matrix3d rotation = rotations_[i].toRotationMatrix();
    for (int j : neighbours_[i])
      energies[i] +=
          0.5 * kEdgeWeight *
          (positions_[i] - positions_[j] - rotation * (rest_[i] - rest_[j])).squaredNorm();
  }
  return energies;
}

}  // namespace isomatch::elastic
