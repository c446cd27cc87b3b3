// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/gltf_attributes.h"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "io/mesh/gltf_colors.h"

namespace isomatch::mesh_io {
namespace {

const Eigen::Vector3d kWhite = Eigen::Vector3d::Ones();

/// The names of a mesh's targets, by a convention that all programs follow, each once.
std::vector<std::string> target_names(const tinygltf::Mesh& mesh, std::size_t targets) {
  tinygltf::Value given;
  if (mesh.extras.IsObject() && mesh.extras.Has("targetNames"))
    given = mesh.extras.Get("targetNames");
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (std::size_t k = 0; k < targets; ++k) {
    const auto number = static_cast<int>(k);
    const bool has_name = given.IsArray() && k < given.ArrayLen() && given.Get(number).IsString();
    std::string name =
        has_name ? given.Get(number).Get<std::string>() : fmt::format("target_{}", k);
    if (taken.contains(name)) name += fmt::format("_{}", k);
    taken.insert(name);
    names.push_back(std::move(name));
  }
  return names;
}

void extend(std::vector<Point>& pose, const std::vector<Point>& rest) {
  pose.insert(pose.end(), rest.begin() + std::ssize(pose), rest.end());
}

}  // namespace

void GltfAttributes::add_colors(const tinygltf::Primitive& primitive,
                                const GltfVertices& vertices) {
  const auto found = primitive.attributes.find("COLOR_0");
  if (found == primitive.attributes.end()) return;
  accessors_.check_rows(found->second, vertices.count);
  const bool has_alpha =
      vertices.count > 0 && model_.accessors[found->second].type == TINYGLTF_TYPE_VEC4;
  const Eigen::MatrixXd values = accessors_.read(found->second, has_alpha ? 4 : 3);
  if (!values.allFinite()) file_.fail("a colour is not finite");
  const std::size_t end = vertices.first + vertices.count;
  if (colors_.size() < end) colors_.resize(end, kWhite);
  for (const int v : vertices.own)
    colors_[vertices.first + v] = to_srgb(Eigen::Vector3d(values.row(v).head<3>()));
}

void GltfAttributes::add_poses(const tinygltf::Mesh& mesh, const tinygltf::Primitive& primitive,
                               const GltfVertices& vertices, const Eigen::Affine3d& to_scene,
                               const std::vector<Point>& rest) {
  if (primitive.targets.empty()) return;
  const Eigen::MatrixXd positions = accessors_.read(primitive.attributes.at("POSITION"), 3);
  const std::vector<std::string> names = target_names(mesh, primitive.targets.size());
  for (std::size_t k = 0; k < primitive.targets.size(); ++k) {
    std::vector<Point>& pose = pose_named(names[k], rest);
    const auto found = primitive.targets[k].find("POSITION");
    if (found == primitive.targets[k].end()) continue;
    accessors_.check_rows(found->second, vertices.count);
    const Eigen::MatrixXd moved = positions + accessors_.read(found->second, 3);
    for (const int v : vertices.own) {
      Point& point = pose[vertices.first + v];
      point = moved.row(v);
      // Leaves every bit as it is where nothing moves.
      if (!to_scene.matrix().isIdentity(0)) point = to_scene * point;
    }
  }
}

std::vector<Point>& GltfAttributes::pose_named(const std::string& name,
                                               const std::vector<Point>& rest) {
  const auto [entry, is_new] = pose_of_name_.try_emplace(name, poses_.size());
  if (is_new) poses_.push_back({name, {}});
  std::vector<Point>& pose = poses_[entry->second].vertices;
  extend(pose, rest);
  return pose;
}

VertexColors GltfAttributes::colors(std::size_t vertices) && {
  if (!colors_.empty()) colors_.resize(vertices, kWhite);
  return std::move(colors_);
}

std::vector<Pose> GltfAttributes::poses(const std::vector<Point>& rest) && {
  for (Pose& pose : poses_) extend(pose.vertices, rest);
  return std::move(poses_);
}

}  // namespace isomatch::mesh_io
