// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/hypotheses/node_directions.h"

#include "geometry/hat_gradients.h"
#include "geometry/tangent_frame.h"

namespace isomatch::tracked {
namespace {

/// The linear map from values at the vertices around a vertex to the gradient in its tangent plane,
/// as a complex number.
struct GradientStencil {
  std::vector<int> vertices;
  std::vector<std::complex<float>> weights;

  std::complex<float> operator()(const float* field) const {
    std::complex<float> sum = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) sum += field[vertices[i]] * weights[i];
    return sum;
  }
};

GradientStencil gradient_stencil(const Proxy& proxy, int vertex) {
  const TangentFrame frame = tangent_frame(proxy.normals[vertex]);
  GradientStencil stencil;
  for (int f : proxy.faces[vertex]) {
    const Face& face = proxy.mesh.faces[f];
    const std::array<Point, 3> gradients = hat_gradients(proxy.mesh, face);
    for (int k = 0; k < 3; ++k) {
      stencil.vertices.push_back(face[k]);
      const Eigen::Vector2d gradient = frame.coordinates(gradients[k]);
      stencil.weights.emplace_back(gradient.x(), gradient.y());
    }
  }
  return stencil;
}

}  // namespace

NodeDirections::NodeDirections(const Proxy& proxy, std::vector<int> nodes)
    : nodes_(std::move(nodes)),
      oriented_(proxy.oriented),
      distances_(nodes_.size(), nodes_.size()),
      least_(nodes_.size(), nodes_.size()),
      directions_(nodes_.size() * nodes_.size()) {
  for (int a = 0; a < size(); ++a) {
    const GradientStencil gradient = gradient_stencil(proxy, proxy.nodes[nodes_[a]]);
    for (int b = 0; b < size(); ++b) {
      distances_(a, b) = proxy.node_distance(nodes_[a], nodes_[b]);
      least_(a, b) = proxy.least_distance(nodes_[a], nodes_[b]);
      const std::complex<float> uphill = gradient(proxy.distances.row(nodes_[b]).data());
      const float norm = std::abs(uphill);
      if (a != b && norm > 0) directions_[a * nodes_.size() + b] = -uphill / norm;
    }
  }
}

}  // namespace isomatch::tracked
