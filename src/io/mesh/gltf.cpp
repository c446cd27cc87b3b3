// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "io/mesh/checks.h"
#include "io/mesh/formats.h"
#include "io/mesh/gltf_accessors.h"
#include "io/mesh/gltf_attributes.h"
#include "io/mesh/gltf_coordinates.h"
#include "io/mesh/gltf_file.h"
#include "io/mesh/gltf_scene.h"

namespace isomatch::mesh_io {
namespace {

/// Whether to read more than the mesh.
enum class Extent { kMesh, kModel };

using Indices = std::vector<std::int64_t>;

class GltfReader {
 public:
  GltfReader(const InputFile& file, const MeshReadOptions& options, Extent extent)
      : file_(file), options_(options), extent_(extent), model_(load_gltf(file)) {}

  ReadResult read() {
    const std::vector<PlacedMesh> chosen = chosen_meshes();
    check_size_of(chosen);
    for (const PlacedMesh& placed : chosen) {
      here_ = Here(placed);
      const std::size_t faces = result_.mesh.faces.size();
      for (const tinygltf::Primitive& primitive : placed.mesh->primitives) {
        if (mode(primitive) < TINYGLTF_MODE_TRIANGLES)
          ++passed_over_;
        else
          add(primitive);
      }
      if (result_.mesh.faces.size() > faces) result_.report.meshes.push_back(placed.name);
    }
    warn_of_lines();
    finish_model();
    return std::move(result_);
  }

 private:
  /// The mesh that is being read.
  struct Here {
    Here() = default;
    explicit Here(const PlacedMesh& placed)
        : mesh(placed.mesh),
          transform(placed.transform),
          is_moved(!placed.transform.matrix().isIdentity(0)),
          is_mirrored(placed.transform.linear().determinant() < 0) {}

    const tinygltf::Mesh* mesh = nullptr;
    Eigen::Affine3d transform;
    bool is_moved = false, is_mirrored = false;
    /// Of each accessor of positions.
    std::map<int, int> first_vertex;
  };

  static int mode(const tinygltf::Primitive& primitive) {
    return primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  }

  std::vector<PlacedMesh> chosen_meshes() {
    std::vector<PlacedMesh> placed = placed_meshes(file_, model_);
    const std::vector<PlacedMesh> outside = meshes_outside(model_, placed);
    if (options_.mesh) {
      std::vector<PlacedMesh> all = placed;
      all.insert(all.end(), outside.begin(), outside.end());
      placed = named_meshes(file_, all, *options_.mesh);
    } else if (!outside.empty()) {
      warn(fmt::format("not in the scene that is shown, and left out: {}", listed_names(outside)));
    }
    if (std::ranges::count(model_.extensionsUsed, "EXT_mesh_gpu_instancing") > 0)
      warn("EXT_mesh_gpu_instancing is not supported: of each such mesh one copy is read");
    return placed;
  }

  void warn(std::string text) { result_.report.warnings.push_back(std::move(text)); }

  void warn_of_lines() {
    if (passed_over_ == 0) return;
    if (result_.mesh.vertices.empty()) file_.fail("has no triangles, only lines or points");
    warn(passed_over_ == 1 ? "a part of lines or points is left out"
                           : fmt::format("{} parts of lines or points are left out", passed_over_));
  }

  /// A small file can show a large mesh any number of times.
  void check_size_of(const std::vector<PlacedMesh>& meshes) const {
    constexpr std::size_t kFew = 100'000'000, kMost = std::numeric_limits<int>::max();
    const std::size_t most = std::clamp(accessors_.total_bytes(), kFew, kMost);
    std::size_t size = 0;
    for (const PlacedMesh& placed : meshes) {
      for (const tinygltf::Primitive& primitive : placed.mesh->primitives) {
        size += 1 + count_or_none(primitive.indices) + count_or_none(positions_of(primitive));
        if (size > most) file_.fail("shows its meshes more often than this program can read them");
      }
    }
  }

  static int positions_of(const tinygltf::Primitive& primitive) {
    const auto found = primitive.attributes.find("POSITION");
    return found == primitive.attributes.end() ? -1 : found->second;
  }

  std::size_t count_or_none(int accessor) const {
    return accessor < 0 ? 0 : accessors_.count(accessor);
  }

  void add(const tinygltf::Primitive& primitive) {
    const int positions = positions_of(primitive);
    if (positions < 0) file_.fail("a part of the mesh has no positions");
    const auto count = static_cast<int>(
        std::min<std::size_t>(accessors_.count(positions), std::numeric_limits<int>::max()));
    // Parts of a mesh may share their vertices.
    const auto [entry, is_new] =
        here_.first_vertex.try_emplace(positions, static_cast<int>(result_.mesh.vertices.size()));
    if (is_new) add_vertices(positions);
    const Indices indices = corners(primitive, count);
    const std::size_t first_face = result_.mesh.faces.size();
    for (const std::int64_t index : indices) checked_index(file_, index, count);
    add_faces(primitive, entry->second, indices);
    if (extent_ == Extent::kMesh) return;
    const GltfVertices vertices{entry->second, count, own(entry->second, count, indices, is_new)};
    attributes_.add_colors(primitive, vertices);
    attributes_.add_poses(*here_.mesh, primitive, vertices, here_.transform, result_.mesh.vertices);
    cover(primitive, vertices, first_face);
  }

  void add_vertices(int positions) {
    const Eigen::MatrixXd values = accessors_.read(positions, 3);
    for (Eigen::Index v = 0; v < values.rows(); ++v) {
      Point point = values.row(v);
      // Leaves every bit as it is where nothing moves.
      if (here_.is_moved) point = here_.transform * point;
      result_.mesh.vertices.push_back(point);
    }
  }

  /// The vertices that have their attributes from a part with these corners: where parts share
  /// vertices, it is the first part that uses them.
  std::vector<int> own(int first, int count, const Indices& indices, bool is_new) {
    is_used_.resize(result_.mesh.vertices.size(), false);
    std::vector<int> vertices;
    if (is_new) {
      vertices.resize(count);
      std::iota(vertices.begin(), vertices.end(), 0);
    }
    for (const std::int64_t index : indices) {
      if (!is_new && !is_used_[first + index]) vertices.push_back(static_cast<int>(index));
      is_used_[first + index] = true;
    }
    return vertices;
  }

  Indices corners(const tinygltf::Primitive& primitive, int vertices) const {
    if (primitive.indices >= 0) return accessors_.read_indices(primitive.indices);
    Indices indices(vertices);
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  }

  void add_faces(const tinygltf::Primitive& primitive, int first_vertex, const Indices& indices) {
    const std::size_t count = indices.size();
    const auto add_face = [&](std::size_t a, std::size_t b, std::size_t c) {
      // A mirror image is turned inside out.
      if (here_.is_mirrored) std::swap(b, c);
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
  void cover(const tinygltf::Primitive& primitive, const GltfVertices& vertices,
             std::size_t first_face) {
    const int number = material(primitive);
    const int first = coordinates_.add(primitive, vertices.count, result_.texture);
    const auto at = [&](int vertex) {
      return first == Texture::kNone ? Texture::kNone : first + vertex - vertices.first;
    };
    const auto& faces = result_.mesh.faces;
    for (std::size_t f = first_face; f < faces.size(); ++f) {
      const auto& [a, b, c] = faces[f];
      result_.texture.corners.push_back({at(a), at(b), at(c)});
      result_.texture.face_material.push_back(number);
    }
  }

  void finish_model() {
    const std::vector<Point>& vertices = result_.mesh.vertices;
    result_.colors = std::move(attributes_).colors(vertices.size());
    result_.poses = std::move(attributes_).poses(vertices);
    if (result_.texture.coordinates.empty()) result_.texture = {};
  }

  const InputFile& file_;
  const MeshReadOptions& options_;
  Extent extent_;
  tinygltf::Model model_;
  GltfAccessors accessors_{file_, model_};
  GltfAttributes attributes_{file_, model_, accessors_};
  GltfCoordinates coordinates_{file_, model_, accessors_};
  Here here_;
  ReadResult result_;
  /// Whether a vertex has its attributes for good, of each vertex.
  std::vector<bool> is_used_;
  int passed_over_ = 0;
};

}  // namespace

ReadResult read_gltf(const InputFile& file, const MeshReadOptions& options) {
  return GltfReader(file, options, Extent::kMesh).read();
}

ReadResult read_gltf_model(const InputFile& file, const MeshReadOptions& options) {
  return GltfReader(file, options, Extent::kModel).read();
}

}  // namespace isomatch::mesh_io
