// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "zoomout/orientation_operator.h"

#include <Eigen/Geometry>

namespace isomatch::baselines {
namespace {

/// The gradients of a face's three hat functions, turned by a right angle about its normal, times
/// twice its area: its edges.
std::array<Point, 3> opposite_edges(const Mesh& mesh, const Face& face) {
  const Point &a = mesh.vertices[face[0]], &b = mesh.vertices[face[1]], &c = mesh.vertices[face[2]];
  return {c - b, a - c, b - a};
}

/// The gradient of `function` on a face, turned by a right angle about its normal.
Point turned_gradient(const std::array<Point, 3>& edges, const Face& face,
                      const Eigen::VectorXd& function) {
  Point turned = Point::Zero();
  for (int k = 0; k < 3; ++k) turned += function[face[k]] * edges[k];
  const double twice_area = edges[0].cross(edges[1]).norm();
  return twice_area > 0 ? Point(turned / twice_area) : Point::Zero();
}

}  // namespace

Eigen::MatrixXd orientation_operator(const Mesh& mesh, const Eigen::MatrixXd& basis,
                                     const Eigen::VectorXd& function) {
  Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(basis.rows(), basis.cols());
  for (const Face& face : mesh.faces) {
    const std::array<Point, 3> edges = opposite_edges(mesh, face);
    const Point gradient = turned_gradient(edges, face, function);
    const Point normal = edges[0].cross(edges[1]).normalized();
    // What a corner's hat function contributes to the derivative along `gradient`, times the area.
    const Point across = gradient.cross(normal) / 2;
    Eigen::RowVectorXd derivative = Eigen::RowVectorXd::Zero(basis.cols());
    for (int k = 0; k < 3; ++k) derivative += across.dot(edges[k]) * basis.row(face[k]);
    for (int v : face) derivatives.row(v) += derivative / 3;
  }
  return basis.transpose() * derivatives;
}

}  // namespace isomatch::baselines
