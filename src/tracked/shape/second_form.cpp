// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/second_form.h"

#include <Eigen/Geometry>
#include <cmath>
#include <span>

#include "geometry/hat_gradients.h"
#include "isomatch/mesh/topology.h"
#include "tracked/shape/heat_flow.h"

namespace isomatch::tracked {
namespace {

/// A tensor of each vertex.
using Tensors = Eigen::MatrixXd;

Point unit_normal(const Mesh& mesh, int face) {
  return area_vector(mesh.vertices, mesh.faces[face]).stableNormalized();
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
  HeatFlow flow(mesh);
  flow.set_length(length);
  std::vector<SecondForm> result(mesh.vertices.size());
  // So many steps of the flow in all average over the square root of their number times `length`.
  int steps = 0;
  for (int scale = 0; scale < kSecondFormScales; ++scale) {
    for (; steps < 1 << scale; ++steps) {
      // Bends are integrals from the start.
      if (steps > 0) forms = flow.integrals(forms);
      forms = flow.step(forms);
    }
    for (int v = 0; v < mesh.num_vertices(); ++v)
      result[v][scale] = forms.row(v).transpose().cast<float>();
  }
  return result;
}

}  // namespace isomatch::tracked
