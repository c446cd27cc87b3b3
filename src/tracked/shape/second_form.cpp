// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/second_form.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <span>

#include "geometry/cotangent_laplacian.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::tracked {
namespace {

using Tensors = Eigen::Matrix<double, Eigen::Dynamic, 6>;

Point unit_normal(const Mesh& mesh, int face) {
  const Face& f = mesh.faces[face];
  const Point& a = mesh.vertices[f[0]];
  return (mesh.vertices[f[1]] - a).cross(mesh.vertices[f[2]] - a).stableNormalized();
}

/// The bend across the edge of two faces, integrated over it, and shared by its ends.
void add_bend(const Mesh& mesh, std::span<const EdgeSide> sides, Tensors& integrals) {
  if (sides.size() != 2) return;
  const Face& face = mesh.faces[sides[0].face];
  const int from = face[(sides[0].corner + 1) % 3], to = face[(sides[0].corner + 2) % 3];
  const Point edge = mesh.vertices[to] - mesh.vertices[from], along = edge.stableNormalized();
  const Point left = unit_normal(mesh, sides[0].face), right = unit_normal(mesh, sides[1].face);
  const double angle = std::atan2(left.cross(right).dot(along), left.dot(right));
  const Point across = (left + right).stableNormalized().cross(along);
  const double bend = angle * edge.norm() / 2;
  const Point &a = across, scaled = bend * across;
  const Eigen::Vector<double, 6> tensor(scaled.x() * a.x(), scaled.y() * a.y(), scaled.z() * a.z(),
                                        scaled.x() * a.y(), scaled.x() * a.z(), scaled.y() * a.z());
  integrals.row(from) += tensor.transpose();
  integrals.row(to) += tensor.transpose();
}

}  // namespace

PlaneForm in_plane(const SymmetricTensor& t, const Point& first, const Point& second) {
  const auto form = [&](const Point& a, const Point& b) {
    return t[0] * a.x() * b.x() + t[1] * a.y() * b.y() + t[2] * a.z() * b.z() +
           t[3] * (a.x() * b.y() + a.y() * b.x()) + t[4] * (a.x() * b.z() + a.z() * b.x()) +
           t[5] * (a.y() * b.z() + a.z() * b.y());
  };
  return {form(first, first), form(second, second), form(first, second)};
}

std::vector<SecondForm> second_forms(const Mesh& mesh, double length) {
  Tensors forms = Tensors::Zero(mesh.num_vertices(), 6);
  for_each_edge(sorted_edge_sides(mesh),
                [&](std::span<const EdgeSide> sides) { add_bend(mesh, sides, forms); });
  const std::vector<double> areas = vertex_areas(mesh);
  const Eigen::Map<const Eigen::VectorXd> area(areas.data(), std::ssize(areas));
  Eigen::SparseMatrix<double> system = cotangent_laplacian(mesh) * (length * length);
  for (int v = 0; v < mesh.num_vertices(); ++v) system.coeffRef(v, v) += areas[v];
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(system);
  if (solver.info() != Eigen::Success) throw SolverFailure("a surface cannot be smoothed");
  std::vector<SecondForm> result(mesh.vertices.size());
  // So many steps of the flow in all average over the square root of their number times `length`.
  int steps = 0;
  for (int scale = 0; scale < kSecondFormScales; ++scale) {
    for (; steps < 1 << scale; ++steps) {
      if (steps > 0) forms = area.asDiagonal() * forms;
      forms = solver.solve(forms);
    }
    for (int v = 0; v < mesh.num_vertices(); ++v)
      result[v][scale] = forms.row(v).transpose().cast<float>();
  }
  return result;
}

}  // namespace isomatch::tracked
