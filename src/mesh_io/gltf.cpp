// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mesh_io/checks.h"
#include "mesh_io/formats.h"
#include "mesh_io/gltf_accessors.h"
#include "mesh_io/gltf_colors.h"
#include "mesh_io/gltf_file.h"

namespace isomatch::mesh_io {
namespace {

/// Whether to read more than the mesh.
enum class Extent { kMesh, kModel };

class GltfReader {
 public:
  GltfReader(const InputFile& file, Extent extent)
      : file_(file),
        extent_(extent),
        model_(load_gltf(file)),
        accessors_(file, model_),
        placed_(first_mesh(file, model_)) {}

  ReadResult read() {
    for (const tinygltf::Primitive& primitive : placed_.mesh->primitives)
      // The others are points and lines.
      if (mode(primitive) >= TINYGLTF_MODE_TRIANGLES) add(primitive);
    drop_partial();
    return std::move(result_);
  }

 private:
  static int mode(const tinygltf::Primitive& primitive) {
    return primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  }

  static int attribute(const std::map<std::string, int>& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
  }

  void add(const tinygltf::Primitive& primitive) {
    const int positions = attribute(primitive.attributes, "POSITION");
    if (positions < 0) file_.fail("a part of the mesh has no positions");
    const auto count = static_cast<int>(
        std::min<std::size_t>(accessors_.count(positions), std::numeric_limits<int>::max()));
    // Parts of a mesh may share their vertices.
    const auto [entry, is_new] =
        first_vertex_.try_emplace(positions, static_cast<int>(result_.mesh.vertices.size()));
    if (is_new) add_vertices(primitive, positions);
    const std::size_t first_face = result_.mesh.faces.size();
    add_faces(primitive, entry->second, count);
    if (extent_ == Extent::kModel) cover(primitive, first_face);
  }

  void add_vertices(const tinygltf::Primitive& primitive, int positions) {
    const Eigen::MatrixXd values = accessors_.read(positions, 3);
    for (Eigen::Index v = 0; v < values.rows(); ++v)
      result_.mesh.vertices.push_back(finite(in_scene(values.row(v))));
    if (result_.mesh.vertices.size() > std::numeric_limits<int>::max())
      file_.fail("the mesh has more vertices than this program can number");
    if (extent_ == Extent::kMesh) return;
    add_coordinates(attribute(primitive.attributes, "TEXCOORD_0"), values.rows());
    add_colors(attribute(primitive.attributes, "COLOR_0"), values.rows());
    add_poses(primitive, values);
  }

  /// Leaves every bit as it is where nothing moves.
  Point in_scene(const Point& point) const {
    return is_moved_ ? Point(placed_.transform * point) : point;
  }

  const Point& finite(const Point& point) const {
    if (!point.allFinite()) file_.fail("a coordinate is not finite");
    return point;
  }

  Eigen::MatrixXd read_rows(int accessor, int components, Eigen::Index rows) const {
    Eigen::MatrixXd values = accessors_.read(accessor, components);
    if (values.rows() != rows)
      file_.fail(fmt::format("accessor {} has {} elements for {} vertices", accessor, values.rows(),
                             rows));
    return values;
  }

  void add_coordinates(int accessor, Eigen::Index rows) {
    coordinates_at_.resize(result_.mesh.vertices.size(), Texture::kNone);
    if (accessor < 0) return;
    const Eigen::MatrixXd values = read_rows(accessor, 2, rows);
    if (!values.allFinite()) file_.fail("a texture coordinate is not finite");
    const std::size_t first = result_.mesh.vertices.size() - rows;
    for (Eigen::Index v = 0; v < rows; ++v) {
      coordinates_at_[first + v] = static_cast<int>(result_.texture.coordinates.size());
      // glTF counts from the upper left corner of an image.
      result_.texture.coordinates.emplace_back(values(v, 0), 1 - values(v, 1));
    }
  }

  void add_colors(int accessor, Eigen::Index rows) {
    if (accessor < 0) return;
    const bool has_alpha =
        accessors_.count(accessor) > 0 && model_.accessors[accessor].type == TINYGLTF_TYPE_VEC4;
    const Eigen::MatrixXd values = read_rows(accessor, has_alpha ? 4 : 3, rows);
    if (!values.allFinite()) file_.fail("a colour is not finite");
    for (Eigen::Index v = 0; v < rows; ++v)
      result_.colors.push_back(to_srgb(Eigen::Vector3d(values.row(v).head<3>())));
  }

  void add_poses(const tinygltf::Primitive& primitive, const Eigen::MatrixXd& positions) {
    std::vector<Pose>& poses = result_.poses;
    if (poses.size() < primitive.targets.size()) poses.resize(primitive.targets.size());
    for (std::size_t k = 0; k < primitive.targets.size(); ++k) {
      const int accessor = attribute(primitive.targets[k], "POSITION");
      Eigen::MatrixXd moved = positions;
      if (accessor >= 0) moved += read_rows(accessor, 3, positions.rows());
      for (Eigen::Index v = 0; v < moved.rows(); ++v)
        poses[k].vertices.push_back(finite(in_scene(moved.row(v))));
      poses[k].name = target_name(k);
    }
  }

  /// By a convention that all programs follow.
  std::string target_name(std::size_t target) const {
    const tinygltf::Value& extras = placed_.mesh->extras;
    if (extras.IsObject() && extras.Has("targetNames")) {
      const tinygltf::Value& names = extras.Get("targetNames");
      if (names.IsArray() && target < names.ArrayLen() &&
          names.Get(static_cast<int>(target)).IsString())
        return names.Get(static_cast<int>(target)).Get<std::string>();
    }
    return fmt::format("target_{}", target);
  }

  std::vector<std::int64_t> corners(const tinygltf::Primitive& primitive, int vertices) const {
    if (primitive.indices >= 0) return accessors_.read_indices(primitive.indices);
    std::vector<std::int64_t> indices(vertices);
    for (int v = 0; v < vertices; ++v) indices[v] = v;
    return indices;
  }

  void add_faces(const tinygltf::Primitive& primitive, int first_vertex, int vertices) {
    const std::vector<std::int64_t> indices = corners(primitive, vertices);
    const std::size_t count = indices.size();
    for (const std::int64_t index : indices) checked_index(file_, index, vertices);
    const auto add_face = [&](std::size_t a, std::size_t b, std::size_t c) {
      // A mirror image is turned inside out.
      if (is_mirrored_) std::swap(b, c);
      result_.mesh.faces.push_back({first_vertex + static_cast<int>(indices[a]),
                                    first_vertex + static_cast<int>(indices[b]),
                                    first_vertex + static_cast<int>(indices[c])});
    };
    switch (mode(primitive)) {
      case TINYGLTF_MODE_TRIANGLES:
        if (count % 3 != 0) file_.fail(fmt::format("{} indices do not make triangles", count));
        for (std::size_t i = 0; i < count; i += 3) add_face(i, i + 1, i + 2);
        break;
      case TINYGLTF_MODE_TRIANGLE_STRIP:
        for (std::size_t i = 2; i < count; ++i)
          i % 2 == 0 ? add_face(i - 2, i - 1, i) : add_face(i - 1, i - 2, i);
        break;
      case TINYGLTF_MODE_TRIANGLE_FAN:
        for (std::size_t i = 2; i < count; ++i) add_face(0, i - 1, i);
        break;
      default:
        file_.fail(fmt::format("{} is no mode of a part of a mesh", mode(primitive)));
    }
  }

  int material(const tinygltf::Primitive& primitive) {
    if (primitive.material < 0 || primitive.material >= std::ssize(model_.materials))
      return Texture::kNone;
    const std::string& given = model_.materials[primitive.material].name;
    const std::string name = given.empty() ? fmt::format("material_{}", primitive.material) : given;
    std::vector<std::string>& names = result_.texture.materials;
    const auto found = std::ranges::find(names, name);
    const auto number = static_cast<int>(found - names.begin());
    if (found == names.end()) names.push_back(name);
    return number;
  }

  /// Texture coordinates and material of the faces from `first_face` on.
  void cover(const tinygltf::Primitive& primitive, std::size_t first_face) {
    const int number = material(primitive);
    const auto& faces = result_.mesh.faces;
    for (std::size_t f = first_face; f < faces.size(); ++f) {
      const auto& [a, b, c] = faces[f];
      result_.texture.corners.push_back(
          {coordinates_at_[a], coordinates_at_[b], coordinates_at_[c]});
      result_.texture.face_material.push_back(number);
    }
  }

  /// What some parts of the mesh do not have, it has not.
  void drop_partial() {
    const std::size_t vertices = result_.mesh.vertices.size();
    if (result_.colors.size() != vertices) result_.colors.clear();
    std::erase_if(result_.poses,
                  [&](const Pose& pose) { return pose.vertices.size() != vertices; });
    if (result_.texture.coordinates.empty()) result_.texture = {};
  }

  const InputFile& file_;
  Extent extent_;
  tinygltf::Model model_;
  GltfAccessors accessors_;
  PlacedMesh placed_;
  bool is_moved_ = !placed_.transform.matrix().isIdentity(0);
  bool is_mirrored_ = placed_.transform.linear().determinant() < 0;
  ReadResult result_;
  /// Of each accessor of positions.
  std::map<int, int> first_vertex_;
  /// Of each vertex its texture coordinates.
  std::vector<int> coordinates_at_;
};

}  // namespace

ReadResult read_gltf(const InputFile& file) { return GltfReader(file, Extent::kMesh).read(); }

ReadResult read_gltf_model(const InputFile& file) {
  return GltfReader(file, Extent::kModel).read();
}

}  // namespace isomatch::mesh_io
