// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/rows.h"

namespace isomatch::elastic {

void Rows::add_multiple(double factor, const Rows& other) {
  for (int i = 0; i < size(); ++i) rows_[i] += factor * other.rows_[i];
}

double dot(const Rows& a, const Rows& b) {
  Rows::Row sum = Rows::Row::Zero();
  for (int i = 0; i < a.size(); ++i) sum += a[i].cwiseProduct(b[i]);
  return sum.sum();
}

Rows solved(const Factors& factors, const Rows& right) {
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  const auto& place = factors.permutationP().indices();
  const auto& lower = factors.matrixL().nestedExpression();  // Without its diagonal of ones.
  const auto diagonal = factors.vectorD();
  const int n = right.size();
  Rows x(n);
  for (int i = 0; i < n; ++i) x[place[i]] = right[i];
  for (int j = 0; j < n; ++j) {
    const Rows::Row known = x[j];
    for (Entry entry(lower, j); entry; ++entry)
      x[static_cast<int>(entry.row())] -= entry.value() * known;
  }
  for (int j = n - 1; j >= 0; --j) {
    Rows::Row sum = x[j] / diagonal[j];
    for (Entry entry(lower, j); entry; ++entry)
      sum -= entry.value() * x[static_cast<int>(entry.row())];
    x[j] = sum;
  }
  Rows result(n);
  for (int i = 0; i < n; ++i) result[i] = x[place[i]];
  return result;
}

}  // namespace isomatch::elastic
