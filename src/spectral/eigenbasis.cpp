// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "spectral/eigenbasis.h"

#include <Spectra/SymEigsSolver.h>

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "geometry/cotangent_laplacian.h"
#include "isomatch/error.h"

namespace isomatch::spectral {
namespace {

/// Multiplies by the inverse of a sparse matrix, as Spectra wants it. Solved in double precision,
/// since the factors are ill-conditioned; the basis itself is in single precision, which halves the
/// time and leaves eigenvalues right to 2e-5.
class Inverse {
 public:
  using Scalar = float;

  Inverse(const Eigen::SparseMatrix<double>& matrix, const Context& context)
      : solver_(matrix), context_(context) {
    if (solver_.info() != Eigen::Success)
      throw SolverFailure("the Laplacian of a surface cannot be factorised");
  }

  Eigen::Index rows() const { return solver_.rows(); }
  Eigen::Index cols() const { return solver_.cols(); }
  void perform_op(const float* in, float* out) const {
    context_.check_stop();
    const Eigen::VectorXd right = Eigen::Map<const Eigen::VectorXf>(in, rows()).cast<double>();
    Eigen::Map<Eigen::VectorXf>(out, rows()) = solver_.solve(right).cast<float>();
  }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  const Context& context_;
};

}  // namespace

Eigenbasis eigenbasis(const Mesh& mesh, int count, const Context& context) {
  // Far from the spectrum of a surface of unit area, near enough to invert well.
  const double area = surface_area(mesh), shift = 1 / area;
  const std::vector<double> areas = vertex_areas(mesh);
  Eigen::VectorXd scale(mesh.num_vertices());
  for (int v = 0; v < mesh.num_vertices(); ++v)
    scale[v] = 1 / std::sqrt(std::max(areas[v], 1e-3 * area / mesh.num_vertices()));
  Eigen::SparseMatrix<double> matrix = scale.asDiagonal() *
                                       Eigen::SparseMatrix<double>(cotangent_laplacian(mesh)) *
                                       scale.asDiagonal();
  for (int v = 0; v < mesh.num_vertices(); ++v) matrix.coeffRef(v, v) += shift;
  Inverse inverse(matrix, context);
  const int n = mesh.num_vertices();
  count = std::min(count, n - 1);
  // With fewer vectors at once some of the equal eigenvalues of spheres and cubes are missed.
  Spectra::SymEigsSolver<Inverse> solver(inverse, count, std::min(n, 2 * count + 20));
  solver.init();
  constexpr int kMaxRestarts = 200;
  constexpr float kTolerance = 1e-5F;
  solver.compute(Spectra::SortRule::LargestMagn, kMaxRestarts, kTolerance);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw SolverFailure("the eigenfunctions of a surface do not converge");
  return {scale.cast<float>().asDiagonal() * solver.eigenvectors(),
          solver.eigenvalues().cast<double>().cwiseInverse().array() - shift};
}

}  // namespace isomatch::spectral
