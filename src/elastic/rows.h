// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "isomatch/mesh/mesh.h"

namespace isomatch::elastic {

/// Coordinates of points as the right side or the solution of a linear system. Those of a point lie
/// side by side, with a zero behind them, so that a processor handles them at once.
class Rows {
 public:
  using Row = Eigen::Vector4d;

  explicit Rows(int size) : rows_(size, Row::Zero()) {}

  int size() const { return static_cast<int>(rows_.size()); }
  Row& operator[](int i) { return rows_[i]; }
  const Row& operator[](int i) const { return rows_[i]; }
  Point point(int i) const { return rows_[i].head<3>(); }
  void set(int i, const Point& point) { rows_[i].head<3>() = point; }
  void add(int i, const Point& point) { rows_[i].head<3>() += point; }
  void add_multiple(double factor, const Rows& other);

 private:
  std::vector<Row> rows_;
};

/// Sum over all coordinates.
double dot(const Rows& a, const Rows& b);

using Factors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

/// The solution of a factorised system. Eigen's own goes through the factors once for each
/// coordinate.
Rows solved(const Factors& factors, const Rows& right);

}  // namespace isomatch::elastic
