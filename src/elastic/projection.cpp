// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "elastic/projection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <nanoflann.hpp>

namespace isomatch::elastic {
namespace {

/// Barycentric weights of the point of a triangle that is closest to `p` (Ericson 2005).
std::array<double, 3> closest_weights(const Point& p, const Point& a, const Point& b,
                                      const Point& c) {
  const Point ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Point bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Point cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

}  // namespace

struct Projection::Index {
  static constexpr int kDimensions = 6 + kFeatures;
  using Coordinates = std::array<double, kDimensions>;
  using Distance = nanoflann::L2_Simple_Adaptor<double, Index>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Distance, Index, kDimensions>;

  static Coordinates coordinates(const Point& position, const Point& normal,
                                 const Features& features, const ProjectionWeights& weights) {
    Coordinates result{};
    for (int k = 0; k < 3; ++k) {
      result[k] = position[k];
      result[3 + k] = weights.normal * normal[k];
    }
    for (int k = 0; k < kReliefs; ++k) result[6 + k] = weights.relief * features.relief[k];
    for (int k = 0; k < kPlaces; ++k) result[6 + kReliefs + k] = weights.place * features.place[k];
    return result;
  }

  std::vector<Coordinates> points;
  std::unique_ptr<Tree> tree;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return points[i][k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

Projection::Projection(const Mesh& mesh, const IndexLists& vertex_faces,
                       const std::vector<Point>& normals, const std::vector<Features>& features,
                       const ProjectionWeights& weights)
    : mesh_(mesh),
      vertex_faces_(vertex_faces),
      normals_(normals),
      weights_(weights),
      index_(std::make_unique<Index>()) {
  index_->points.reserve(mesh.vertices.size());
  for (int v = 0; v < mesh.num_vertices(); ++v)
    index_->points.push_back(
        Index::coordinates(mesh.vertices[v], normals[v], features[v], weights));
  index_->tree = std::make_unique<Index::Tree>(Index::kDimensions, *index_);
}

Projection::~Projection() = default;

int Projection::nearest_vertex(const Point& position, const Point& normal,
                               const Features& features) const {
  const auto query = Index::coordinates(position, normal, features, weights_);
  unsigned int nearest = 0;
  double distance = 0;
  index_->tree->knnSearch(query.data(), 1, &nearest, &distance);
  return static_cast<int>(nearest);
}

Foot Projection::foot_at(int vertex) const {
  Foot foot;
  foot.face = vertex_faces_[vertex].front();
  const Face& face = mesh_.faces[foot.face];
  foot.weights[std::ranges::find(face, vertex) - face.begin()] = 1;
  foot.position = mesh_.vertices[vertex];
  return foot;
}

Foot Projection::operator()(const Point& position, const Point& normal,
                            const Features& features) const {
  const int vertex = nearest_vertex(position, normal, features);
  Foot best = foot_at(vertex);
  double least = (best.position - position).squaredNorm();
  for (int f : vertex_faces_[vertex]) {
    const Face& face = mesh_.faces[f];
    const auto& p = mesh_.vertices;
    const auto weights = closest_weights(position, p[face[0]], p[face[1]], p[face[2]]);
    const Point foot = weights[0] * p[face[0]] + weights[1] * p[face[1]] + weights[2] * p[face[2]];
    const double distance = (foot - position).squaredNorm();
    if (!(distance < least)) continue;  // Nor if a degenerate face makes it no number.
    least = distance;
    best = {f, weights, foot, Point::Zero()};
  }
  const Face& face = mesh_.faces[best.face];
  for (int k = 0; k < 3; ++k) best.normal += best.weights[k] * normals_[face[k]];
  best.normal.normalize();
  return best;
}

}  // namespace isomatch::elastic
