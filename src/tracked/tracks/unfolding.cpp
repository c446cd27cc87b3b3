// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/unfolding.h"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "geometry/closest_point.h"
#include "geometry/disjoint_sets.h"
#include "geometry/hat_gradients.h"
#include "geometry/interpolation.h"
#include "geometry/walk.h"
#include "tracked/tracks/faults.h"

namespace isomatch::tracked {
namespace {

/// Part of a surface that is bent anew. `vertices` are ascending; neighbours are places among them.
struct Patch {
  std::vector<int> vertices;
  /// Those whose gradients are not to be trusted, and those that stay where they are.
  std::vector<bool> core, held;
  IndexLists neighbours;

  int size() const { return static_cast<int>(vertices.size()); }
};

/// Of each vertex how many rings it is away from faces that have faults, `rings` at most.
std::vector<int> ring_numbers(const Surface& surface, const std::vector<double>& faults,
                              int rings) {
  std::vector<int> ring(surface.num_vertices(), rings + 1), reached;
  const auto reach = [&](int face, int number) {
    for (int v : surface.mesh.faces[face]) {
      if (ring[v] <= number) continue;
      ring[v] = number;
      reached.push_back(v);
    }
  };
  for (std::size_t f = 0; f < faults.size(); ++f)
    if (faults[f] > 0) reach(static_cast<int>(f), 0);
  for (std::size_t k = 0; k < reached.size(); ++k)
    if (ring[reached[k]] < rings)
      for (int f : surface.faces[reached[k]]) reach(f, ring[reached[k]] + 1);
  return ring;
}

IndexLists neighbours_within(const Surface& surface, const std::vector<int>& vertices) {
  std::vector<int> place(surface.num_vertices(), kNoVertex), offsets{0}, values;
  for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i]] = static_cast<int>(i);
  for (int v : vertices) {
    for (int f : surface.faces[v])
      for (int w : surface.mesh.faces[f])
        if (w != v && place[w] != kNoVertex) values.push_back(place[w]);
    const auto first = values.begin() + offsets.back();
    std::sort(first, values.end());
    values.erase(std::unique(first, values.end()), values.end());
    offsets.push_back(static_cast<int>(values.size()));
  }
  return {std::move(offsets), std::move(values)};
}

/// The last of the rings around faults is held.
Patch patch_around(const Surface& surface, const std::vector<double>& faults, int core, int rings,
                   const std::vector<int>& kept) {
  const std::vector<int> ring = ring_numbers(surface, faults, rings);
  Patch patch;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    if (ring[v] > rings) continue;
    patch.vertices.push_back(v);
    patch.core.push_back(ring[v] <= core);
    patch.held.push_back(ring[v] == rings || std::ranges::count(kept, v) > 0);
  }
  patch.neighbours = neighbours_within(surface, patch.vertices);
  return patch;
}

/// The linear map that takes the edges around a vertex, and its normal, to where they are now.
Eigen::Matrix3d gradient_at(const Surface& surface, const std::vector<Point>& positions, int v) {
  constexpr double kInertia = 1e-6;  // So that edges and a normal in a plane determine one.
  Eigen::Matrix3d moved = Eigen::Matrix3d::Zero(), rest = Eigen::Matrix3d::Zero();
  Point normal(0, 0, 0);
  for (int f : surface.faces[v]) {
    normal += area_vector(positions, surface.mesh.faces[f]);
    for (int w : surface.mesh.faces[f]) {
      const Point edge = surface.mesh.vertices[w] - surface.mesh.vertices[v];
      rest += edge * edge.transpose();
      moved += (positions[w] - positions[v]) * edge.transpose();
    }
  }
  const double size = rest.trace();
  if (size <= 0) return Eigen::Matrix3d::Identity();
  rest += size * surface.normals[v] * surface.normals[v].transpose() +
          kInertia * size * Eigen::Matrix3d::Identity();
  moved += size * normal.stableNormalized() * surface.normals[v].transpose();
  return moved * rest.inverse();
}

/// Of the vertices of a patch, those of its core interpolated from the others, harmonically.
std::vector<Eigen::Matrix3d> smooth_gradients(const Surface& surface, const Patch& patch,
                                              const std::vector<Point>& positions, int sweeps) {
  std::vector<Eigen::Matrix3d> gradients;
  for (int v : patch.vertices) gradients.push_back(gradient_at(surface, positions, v));
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < patch.size(); ++i) {
      const auto around = patch.neighbours[i];
      if (!patch.core[i] || around.empty()) continue;
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (int j : around) sum += gradients[j];
      gradients[i] = sum / static_cast<double>(around.size());
    }
  }
  return gradients;
}

/// The tangent plane of the target that is nearest to a point.
struct Plane {
  Point foot{0, 0, 0}, normal{0, 0, 0};
};

Plane plane_near(const Surface& target, const SurfacePoint& image, const Point& p) {
  const int start = target.mesh.faces[image.face][0];
  const int vertex = walk_to_vertex(target.mesh, target.faces, start, p);
  const SurfacePoint foot = closest_point_around(target.mesh, target.faces, vertex, p);
  return {position(target.mesh, foot),
          interpolated(target.mesh, target.normals, foot).stableNormalized()};
}

/// Mends a surface that was bent onto another.
class Unfolding {
 public:
  Unfolding(const Surface& source, const Surface& target, const Images& images,
            const UnfoldingOptions& options)
      : source_(source), target_(target), images_(images), options_(options) {}

  /// Positions whose differences are what the smooth gradients make of the edges, drawn to the
  /// target as `pull` says, by Gauss and Seidel's sweeps.
  std::vector<Point> bent(const Patch& patch, std::vector<Point> positions, double pull) const {
    constexpr int kSamePlanes = 10;  // Sweeps after which the planes are looked up anew.
    const auto gradients = smooth_gradients(source_, patch, positions, options_.sweeps);
    std::vector<Plane> planes(patch.vertices.size());
    for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
      for (int i = 0; i < patch.size(); ++i) {
        if (patch.held[i]) continue;
        const int v = patch.vertices[i];
        Point p = integrated(patch, gradients, positions, i);
        const SurfacePoint& image = images_.source_to_target[v];
        if (pull > 0 && image.face != kNoFace) {
          if (sweep % kSamePlanes == 0) planes[i] = plane_near(target_, image, p);
          if (planes[i].normal.dot((gradients[i] * source_.normals[v]).stableNormalized()) >=
              kSameSide)
            p += pull * planes[i].normal.dot(planes[i].foot - p) * planes[i].normal;
        }
        positions[v] = p;
      }
    }
    return positions;
  }

  /// Moves the connected parts of a patch to where they were bent if that is better: if there are
  /// fewer faults, and more so than they move off the images. Returns whether any is.
  bool keep_better(const Patch& patch, const std::vector<double>& mended,
                   const std::vector<Point>& bent, std::vector<Point>& positions) const {
    std::vector<int> part = parts(patch);
    std::vector<double> gain(positions.size(), 0.0);
    const auto part_of = [&](const Face& face) {
      return std::max({part[face[0]], part[face[1]], part[face[2]]});
    };
    for (std::size_t f = 0; f < mended.size(); ++f) {
      const int k = part_of(source_.mesh.faces[f]);
      if (k != kNoVertex) gain[k] += mended[f];
    }
    charge(patch, part, part_of, bent, positions, gain);
    bool any = false;
    for (int v : patch.vertices) {
      constexpr double kRounding = 1e-9;
      if (part[v] == kNoVertex || gain[part[v]] <= kRounding) continue;
      positions[v] = bent[v];
      any = true;
    }
    return any;
  }

 private:
  static constexpr double kSameSide = 0.3;  // As registrations take normals to be compatible.

  Point integrated(const Patch& patch, const std::vector<Eigen::Matrix3d>& gradients,
                   const std::vector<Point>& positions, int i) const {
    const int v = patch.vertices[i];
    const auto around = patch.neighbours[i];
    if (around.empty()) return positions[v];
    Point sum(0, 0, 0);
    for (int j : around) {
      const int w = patch.vertices[j];
      const Point edge = source_.mesh.vertices[v] - source_.mesh.vertices[w];
      sum += positions[w] + 0.5 * (gradients[i] + gradients[j]) * edge;
    }
    return sum / static_cast<double>(around.size());
  }

  /// Of each vertex the lowest one of the part that moves with it, none if it is held.
  std::vector<int> parts(const Patch& patch) const {
    DisjointSets sets(source_.num_vertices());
    for (int i = 0; i < patch.size(); ++i)
      for (int j : patch.neighbours[i])
        if (!patch.held[i] && !patch.held[j]) sets.join(patch.vertices[i], patch.vertices[j]);
    std::vector<int> part(source_.num_vertices(), kNoVertex);
    for (int i = 0; i < patch.size(); ++i)
      if (!patch.held[i]) part[patch.vertices[i]] = sets.find(patch.vertices[i]);
    return part;
  }

  /// Takes from the gain of each part what it moves off the images.
  template <class PartOf>
  void charge(const Patch& patch, const std::vector<int>& part, const PartOf& part_of,
              const std::vector<Point>& bent, const std::vector<Point>& positions,
              std::vector<double>& gain) const {
    for (int v : patch.vertices) {
      const SurfacePoint& image = images_.source_to_target[v];
      if (part[v] == kNoVertex || image.face == kNoFace) continue;
      const Point goal = position(target_.mesh, image);
      const double off = (bent[v] - goal).norm() - (positions[v] - goal).norm();
      gain[part[v]] -= options_.drift_price * std::max(0.0, off);
    }
    for (std::size_t t = 0; t < images_.target_to_source.size(); ++t) {
      const SurfacePoint& image = images_.target_to_source[t];
      if (image.face == kNoFace) continue;
      const Face& face = source_.mesh.faces[image.face];
      const int k = part_of(face);
      if (k == kNoVertex) continue;
      Point before = -target_.mesh.vertices[t], after = before;
      for (int corner = 0; corner < 3; ++corner) {
        before += image.weights[corner] * positions[face[corner]];
        after += image.weights[corner] * bent[face[corner]];
      }
      const double off = after.norm() - std::max(options_.covered, before.norm());
      gain[k] -= options_.uncovered_price * std::max(0.0, off);
    }
  }

  const Surface& source_;
  const Surface& target_;
  const Images& images_;
  const UnfoldingOptions& options_;
};

}  // namespace

std::vector<Point> unfolded(const Surface& source, std::vector<Point> positions,
                            const Surface& target, const Images& images,
                            const std::vector<int>& kept, const UnfoldingOptions& options,
                            const Context& context) {
  // Patches of several sizes in turn, as what one does not mend another does.
  constexpr int kCores = 2, kSizes = 3;
  const Faults faults(source.mesh);
  const Unfolding unfolding(source, target, images, options);
  std::vector<double> before = faults(positions);
  for (int round = 0; round < options.rounds; ++round) {
    context.check_stop();
    if (std::ranges::none_of(before, [](double fault) { return fault > 0; })) break;
    const Patch patch = patch_around(source, before, round % kCores, 1 + round % kSizes, kept);
    const double pull = round % kCores == 0 ? 0 : options.pull;
    const std::vector<Point> bent = unfolding.bent(patch, positions, pull);
    std::vector<double> mended = faults(bent);
    for (std::size_t f = 0; f < mended.size(); ++f) mended[f] = before[f] - mended[f];
    if (unfolding.keep_better(patch, mended, bent, positions)) before = faults(positions);
  }
  return positions;
}

}  // namespace isomatch::tracked
