// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "carry/gradients.h"
#include "carry/pose_rotations.h"
#include "geometry/cotangent_laplacian.h"
#include "geometry/kd_tree.h"
#include "geometry/walk.h"
#include "geometry/weld.h"
#include "isomatch/carry/pose_transfer.h"
#include "isomatch/error.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

/// The map of welded vertices: of those at one place the first that is matched counts.
SurfaceMap welded_map(const WeldedMesh& target, const SurfaceMap& target_to_source) {
  SurfaceMap result(target.mesh.vertices.size());
  for (std::size_t v = 0; v < target_to_source.size(); ++v) {
    SurfacePoint& point = result[target.vertex[v]];
    if (point.face == kNoFace) point = target_to_source[v];
  }
  return result;
}

/// For each target face the source face that it deforms like, `kNoFace` if a corner is unmatched.
std::vector<int> source_faces(const Mesh& source, const transfer::FaceGradients& gradients,
                              const Mesh& target, const SurfaceMap& map) {
  const WeldedMesh welded = weld(source);
  const IndexLists around = vertex_faces(welded.mesh);
  std::vector<int> result(target.faces.size(), kNoFace);
  for (std::size_t f = 0; f < result.size(); ++f) {
    const auto& [a, b, c] = target.faces[f];
    const std::array<int, 3> starts{map[a].face, map[b].face, map[c].face};
    if (std::ranges::count(starts, kNoFace) > 0) continue;
    const Point centre =
        (position(source, map[a]) + position(source, map[b]) + position(source, map[c])) / 3;
    const int face = walk_to_point(welded.mesh, around, starts, centre).face;
    if (gradients.has(face)) result[f] = face;
  }
  return result;
}

/// For each face the nearest one for which `is_start` holds, by steps across edges; `kNoFace` where
/// there is none in the component.
template <class Predicate>
std::vector<int> nearest_faces(const Mesh& mesh, const Predicate& is_start) {
  const auto neighbours = face_neighbours(mesh);
  std::vector<int> nearest(mesh.faces.size(), kNoFace), queue;
  for (int f = 0; f < mesh.num_faces(); ++f) {
    if (!is_start(f)) continue;
    nearest[f] = f;
    queue.push_back(f);
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (int f : neighbours[queue[next]]) {
      if (f == kNoFace || nearest[f] != kNoFace) continue;
      nearest[f] = nearest[queue[next]];
      queue.push_back(f);
    }
  }
  return nearest;
}

/// A part of the target that is connected.
struct Component {
  std::vector<int> vertices;
  /// Share of each vertex in the component's place, in their order; empty if nothing is matched.
  std::vector<double> shares;
  /// Of an unmatched component: its own vertex and the carried one that are closest, and the face
  /// that says how the latter turns.
  int own = kNoVertex, leader = kNoVertex, leading_face = kNoFace;
};

}  // namespace

struct PoseTransfer::Parts {
  Mesh source;
  WeldedMesh target;
  SurfaceMap map;
  transfer::FaceGradients gradients;
  transfer::RestPose rest;
  bool same_rest_pose;
  /// Target face to the matched target face it follows, and that to its source face.
  std::vector<int> leading_face, source_face;
  std::vector<Component> components;
  std::vector<bool> followers;
  Solver solver;

  Parts(const Mesh& source_mesh, const Mesh& target_mesh, const SurfaceMap& target_to_source,
        const PoseTransferOptions& options)
      : source(source_mesh),
        target(weld(target_mesh)),
        map(welded_map(target, target_to_source)),
        gradients(source),
        rest(transfer::fit_rest_pose(source, target.mesh, map)),
        same_rest_pose(options.same_rest_pose),
        source_face(source_faces(source, gradients, target.mesh, map)) {
    if (same_rest_pose) std::ranges::fill(rest.rotations, Eigen::Matrix3d::Identity());
    leading_face =
        nearest_faces(target.mesh, [&](int face) { return source_face[face] != kNoFace; });
    if (std::ranges::all_of(leading_face, [](int f) { return f == kNoFace; }))
      throw InvalidInput("no face of the target is matched: there is nothing to carry poses by");
    find_components();
    find_followers(target_mesh);
    lead_unmatched_components();
    factorise();
  }

  void find_components() {
    const std::vector<int> label = vertex_components(target.mesh);
    components.resize(1 + std::ranges::max(label));
    const std::vector<double> areas = vertex_areas(target.mesh);
    std::vector<double> sums(components.size(), 0);
    const auto share = [&](int v) { return map[v].face == kNoFace ? 0 : areas[v]; };
    for (std::size_t v = 0; v < label.size(); ++v) {
      components[label[v]].vertices.push_back(static_cast<int>(v));
      sums[label[v]] += share(static_cast<int>(v));
    }
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (!(sums[c] > 0)) continue;
      for (int v : components[c].vertices) components[c].shares.push_back(share(v) / sums[c]);
    }
    // A component needs a face that says how it deforms, too.
    std::vector<bool> deforms(components.size(), false);
    for (int f = 0; f < target.mesh.num_faces(); ++f)
      if (leading_face[f] != kNoFace) deforms[label[target.mesh.faces[f][0]]] = true;
    for (std::size_t c = 0; c < components.size(); ++c)
      if (!deforms[c]) components[c].shares.clear();
  }

  void find_followers(const Mesh& target_mesh) {
    std::vector<bool> carried(target.mesh.vertices.size(), false);
    for (int f = 0; f < target.mesh.num_faces(); ++f)
      if (source_face[f] != kNoFace)
        for (int v : target.mesh.faces[f]) carried[v] = true;
    followers.resize(target_mesh.vertices.size());
    for (std::size_t v = 0; v < followers.size(); ++v) followers[v] = !carried[target.vertex[v]];
  }

  /// Finds whom components without a match follow.
  void lead_unmatched_components() {
    std::vector<Point> places;
    std::vector<int> vertices, faces;
    for (int f = 0; f < target.mesh.num_faces(); ++f) {
      if (source_face[f] == kNoFace) continue;
      for (int v : target.mesh.faces[f]) {
        places.push_back(target.mesh.vertices[v]);
        vertices.push_back(v);
        faces.push_back(f);
      }
    }
    const KdTree<3> tree(places);
    for (Component& component : components) {
      if (!component.shares.empty()) continue;
      double least = std::numeric_limits<double>::infinity();
      for (int v : component.vertices) {
        const int nearest = tree.nearest(target.mesh.vertices[v]);
        const double distance = (places[nearest] - target.mesh.vertices[v]).norm();
        if (distance >= least) continue;
        least = distance;
        component.own = v;
        component.leader = vertices[nearest];
        component.leading_face = faces[nearest];
      }
    }
  }

  /// Where each component is, the equations leave open: its first vertex is held.
  void factorise() {
    Eigen::SparseMatrix<double> system = cotangent_laplacian(target.mesh);
    for (const Component& component : components)
      system.coeffRef(component.vertices[0], component.vertices[0]) += 1;
    // Vertices between degenerate faces only may be held by nothing.
    for (int v = 0; v < system.rows(); ++v)
      if (!(system.coeff(v, v) > 0)) system.coeffRef(v, v) = 1;
    solver.compute(system);
    if (solver.info() != Eigen::Success)
      throw SolverFailure("the target's faces are too badly shaped to carry poses");
  }

  Eigen::Matrix3d gradient(int leading, std::span<const Point> frame) const {
    const int face = source_face[leading];
    // What stands still does so to the last bit.
    const bool moves = std::ranges::any_of(source.faces[face],
                                           [&](int v) { return frame[v] != source.vertices[v]; });
    return moves ? gradients(face, frame) * rest.rotations[leading] : rest.rotations[leading];
  }

  /// Solves for how vertices move, so that those that nothing moves stay.
  Eigen::MatrixX3d deform(std::span<const Point> frame) const {
    const Mesh& mesh = target.mesh;
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(mesh.num_vertices(), 3);
    for (int f = 0; f < mesh.num_faces(); ++f) {
      if (leading_face[f] == kNoFace) continue;
      const Eigen::Matrix3d change = gradient(leading_face[f], frame) - identity;
      const Face& face = mesh.faces[f];
      for (int corner = 0; corner < 3; ++corner) {
        const int a = face[(corner + 1) % 3], b = face[(corner + 2) % 3];
        const Point pull =
            cotangent_weight(mesh, face, corner) * (change * (mesh.vertices[a] - mesh.vertices[b]));
        right.row(a) += pull.transpose();
        right.row(b) -= pull.transpose();
      }
    }
    Eigen::MatrixX3d positions = solver.solve(right);
    for (int v = 0; v < mesh.num_vertices(); ++v) positions.row(v) += mesh.vertices[v].transpose();
    return positions;
  }

  /// Where the matched vertex `v` belongs, by itself.
  Point goal(int v, std::span<const Point> frame) const {
    const Face& face = source.faces[map[v].face];
    Point there(0, 0, 0);
    for (int k = 0; k < 3; ++k) {
      const Point& from = frame[face[k]];
      there += map[v].weights[k] * (same_rest_pose ? Point(from - source.vertices[face[k]]) : from);
    }
    return same_rest_pose ? Point(target.mesh.vertices[v] + rest.scale * there)
                          : Point(rest.scale * there);
  }

  void place(const Component& component, std::span<const Point> frame,
             Eigen::MatrixX3d& positions) const {
    Point shift(0, 0, 0);
    for (std::size_t i = 0; i < component.vertices.size(); ++i) {
      const int v = component.vertices[i];
      if (component.shares[i] == 0) continue;
      shift += component.shares[i] * (goal(v, frame) - Point(positions.row(v)));
    }
    for (int v : component.vertices) positions.row(v) += shift.transpose();
  }

  void follow(const Component& component, std::span<const Point> frame,
              Eigen::MatrixX3d& positions) const {
    const Eigen::Matrix3d turned = gradient(component.leading_face, frame);
    const auto& at_rest = target.mesh.vertices;
    const Point leader = positions.row(component.leader);
    for (int v : component.vertices)
      positions.row(v) = leader + turned * (at_rest[v] - at_rest[component.leader]);
  }
};

PoseTransfer::PoseTransfer(const Mesh& source, const Mesh& target,
                           const SurfaceMap& target_to_source, const PoseTransferOptions& options) {
  validate_finite(source);
  validate_finite(target);
  check_map(target_to_source, target.num_vertices(), source.num_faces());
  parts_ = std::make_unique<const Parts>(source, target, target_to_source, options);
}

PoseTransfer::~PoseTransfer() = default;
PoseTransfer::PoseTransfer(PoseTransfer&&) noexcept = default;

std::vector<Point> PoseTransfer::operator()(std::span<const Point> frame) const {
  const Parts& parts = *parts_;
  if (frame.size() != parts.source.vertices.size())
    throw InvalidInput(fmt::format("a frame has {} vertices, the source {}", frame.size(),
                                   parts.source.num_vertices()));
  if (!std::ranges::all_of(frame, [](const Point& p) { return p.allFinite(); }))
    throw InvalidInput("a frame has a position that is not finite");
  Eigen::MatrixX3d positions = parts.deform(frame);
  for (const Component& component : parts.components)
    if (!component.shares.empty()) parts.place(component, frame, positions);
  for (const Component& component : parts.components)
    if (component.shares.empty()) parts.follow(component, frame, positions);
  std::vector<Point> result;
  result.reserve(parts.target.vertex.size());
  for (int v : parts.target.vertex) result.emplace_back(positions.row(v));
  return result;
}

const std::vector<bool>& PoseTransfer::followers() const { return parts_->followers; }

}  // namespace isomatch
