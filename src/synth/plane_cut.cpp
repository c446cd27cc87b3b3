// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/plane_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::synth {
namespace {

/// The area of what remains jumps where a limb comes off, so that some directions have no plane for
/// a share; another one soon has.
constexpr int kCutDirections = 20;
constexpr double kTolerance = 0.01;

Eigen::Vector3d random_direction(Random& random) {
  const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Faces in the order in which a plane that moves along `direction` leaves them behind.
std::vector<int> passed_faces(const Mesh& mesh, const Eigen::Vector3d& direction) {
  std::vector<double> heights(mesh.faces.size());
  std::ranges::transform(mesh.faces, heights.begin(), [&](const Face& face) {
    const auto height = [&](int v) { return direction.dot(mesh.vertices[v]); };
    return std::max({height(face[0]), height(face[1]), height(face[2])});
  });
  std::vector<int> order(heights.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int f) { return heights[f]; });
  return order;
}

/// A surface that gains a face after the other, and its largest component.
class GrowingSurface {
 public:
  /// Keeps a reference to `mesh`.
  explicit GrowingSurface(const Mesh& mesh)
      : mesh_(&mesh),
        neighbours_(face_neighbours(mesh)),
        components_(mesh.num_faces()),
        areas_(mesh.faces.size()) {}

  void add(int face) {
    double area = face_area(*mesh_, face);
    for (int neighbour : neighbours_[face]) {
      if (neighbour == kNoFace || areas_[neighbour] == 0) continue;
      const int root = components_.find(neighbour);
      if (root == components_.find(face)) continue;
      area += areas_[root];
      components_.join(root, face);
    }
    areas_[face] = areas_[components_.find(face)] = area;
    largest_ = std::max(largest_, area);
  }

  double largest_area() const { return largest_; }

 private:
  const Mesh* mesh_;
  std::vector<std::array<int, 3>> neighbours_;
  DisjointSets components_;
  std::vector<double> areas_;  ///< At the component's root; 0 of faces that are not added yet.
  double largest_ = 0;
};

struct Cut {
  std::vector<int> faces;  ///< Those that remain.
  double error = std::numeric_limits<double>::infinity();
};

/// The cut across `direction` whose largest component comes closest to `area`.
Cut best_cut(const Mesh& mesh, const Eigen::Vector3d& direction, double area) {
  Cut cut{passed_faces(mesh, direction)};
  GrowingSurface surface(mesh);
  std::size_t count = 0;
  for (std::size_t i = 0; i < cut.faces.size() && surface.largest_area() < area; ++i) {
    surface.add(cut.faces[i]);
    const double error = std::abs(surface.largest_area() - area);
    if (error >= cut.error) continue;
    cut.error = error;
    count = i + 1;
  }
  cut.faces.resize(count);
  return cut;
}

}  // namespace

Mesh cut_by_plane(Mesh mesh, double share, Random& random) {
  const double area = surface_area(mesh);
  Cut best;
  for (int i = 0; i < kCutDirections && best.error > kTolerance * area; ++i) {
    Cut cut = best_cut(mesh, random_direction(random), (1 - share) * area);
    if (cut.error < best.error) best = std::move(cut);
  }
  std::ranges::sort(best.faces);
  std::vector<Face> faces(best.faces.size());
  std::ranges::transform(best.faces, faces.begin(), [&](int f) { return mesh.faces[f]; });
  mesh.faces = std::move(faces);
  return mesh;
}

}  // namespace isomatch::synth
