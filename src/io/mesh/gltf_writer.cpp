// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <tiny_gltf.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "io/byte_order.h"
#include "io/mesh/formats.h"
#include "io/mesh/gltf_colors.h"
#include "io/mesh/gltf_corners.h"
#include "isomatch/error.h"

namespace isomatch::mesh_io {
namespace {

/// What makes a glTF file: `.glb` with its buffer inside, `.gltf` with it as a data URI.
enum class Container { kGlb, kGltf };

using Rows = std::vector<Eigen::Vector3d>;

/// `values` as they are kept in a file.
Rows rounded(Rows values) {
  // One by one: two casts in a row do not round where Eigen turns them into vector instructions.
  for (Eigen::Vector3d& value : values)
    for (double& c : value) c = static_cast<float>(c);
  return values;
}

Rows differences(const Rows& to, const Rows& from) {
  Rows result;
  result.reserve(to.size());
  for (std::size_t v = 0; v < to.size(); ++v) result.emplace_back(to[v] - from[v]);
  return result;
}

/// Unit normals; some for vertices without a face too, as glTF knows no other.
Rows unit_normals(const Mesh& mesh) {
  Rows normals = weighted_vertex_normals(mesh);
  for (Eigen::Vector3d& normal : normals) {
    const double length = normal.stableNorm();
    normal = length > 0 && std::isfinite(length) ? Eigen::Vector3d(normal / length)
                                                 : Eigen::Vector3d::UnitZ();
  }
  return normals;
}

class GltfWriter {
 public:
  GltfWriter(const Model& model, const AtomicFile& file)
      : model_(model), file_(file), split_(split_vertices(model)) {
    document_.asset.version = "2.0";
    document_.asset.generator = "isomatch";
    document_.buffers.resize(1);
  }

  std::string write(Container container) {
    add_primitive();
    add_scene();
    const bool binary = container == Container::kGlb;
    std::ostringstream stream;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&document_, stream, !binary, binary))
      throw InternalError(file_.path() + ": no glTF file could be made");
    return std::move(stream).str();
  }

 private:
  void add_primitive() {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = 0;
    const Rows positions = rounded(model_.mesh.vertices);
    const Rows normals = rounded(unit_normals(model_.mesh));
    primitive.attributes["POSITION"] = add_bounded(positions);
    primitive.attributes["NORMAL"] = add_rows(normals);
    if (!model_.colors.empty()) primitive.attributes["COLOR_0"] = add_colors();
    if (!split_.coordinates.empty()) primitive.attributes["TEXCOORD_0"] = add_coordinates();
    primitive.indices = add_indices();
    for (const Pose& pose : model_.poses)
      primitive.targets.push_back(
          {{"POSITION", add_bounded(differences(pose.vertices, positions))},
           {"NORMAL",
            add_rows(differences(unit_normals({pose.vertices, model_.mesh.faces}), normals))}});
    tinygltf::Mesh mesh;
    mesh.primitives.push_back(std::move(primitive));
    name_targets(mesh);
    document_.meshes.push_back(std::move(mesh));
  }

  void name_targets(tinygltf::Mesh& mesh) const {
    if (model_.poses.empty()) return;
    tinygltf::Value::Array names;
    for (const Pose& pose : model_.poses) names.emplace_back(pose.name);
    mesh.weights.assign(model_.poses.size(), 0);
    mesh.extras = tinygltf::Value(tinygltf::Value::Object{{"targetNames", tinygltf::Value(names)}});
  }

  void add_scene() {
    tinygltf::Material material;
    material.name = "surface";
    material.doubleSided = true;
    material.pbrMetallicRoughness.metallicFactor = 0;
    material.pbrMetallicRoughness.roughnessFactor = 0.8;
    document_.materials.push_back(std::move(material));
    tinygltf::Node node;
    node.name = "mesh";
    node.mesh = 0;
    document_.nodes.push_back(std::move(node));
    tinygltf::Scene scene;
    scene.nodes = {0};
    document_.scenes.push_back(std::move(scene));
    document_.defaultScene = 0;
  }

  template <class T>
  void append(T value) {
    append_little_endian(value, document_.buffers[0].data);
  }

  void append_float(double value) {
    const auto narrow = static_cast<float>(value);
    if (!std::isfinite(narrow))
      throw BadFile(
          file_.path(),
          "a coordinate is not finite, or too large for the 32 bits that glTF has for it");
    append(narrow);
  }

  /// The accessor of all that is appended to the buffer from `start` on.
  int finish(std::size_t start, int target, tinygltf::Accessor accessor) {
    const std::size_t end = document_.buffers[0].data.size();
    if (end > std::numeric_limits<std::uint32_t>::max() / 2)
      throw BadFile(file_.path(), "the mesh is too large for a glTF file");
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = start;
    view.byteLength = end - start;
    view.target = target;
    document_.bufferViews.push_back(std::move(view));
    accessor.bufferView = static_cast<int>(document_.bufferViews.size()) - 1;
    document_.accessors.push_back(std::move(accessor));
    return static_cast<int>(document_.accessors.size()) - 1;
  }

  tinygltf::Accessor of_vertices(int type) const {
    tinygltf::Accessor accessor;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = type;
    accessor.count = split_.original.size();
    return accessor;
  }

  int add_rows(const Rows& rows) {
    const std::size_t start = document_.buffers[0].data.size();
    for (const int v : split_.original)
      for (const double value : rows[v]) append_float(value);
    return finish(start, TINYGLTF_TARGET_ARRAY_BUFFER, of_vertices(TINYGLTF_TYPE_VEC3));
  }

  /// With the least and greatest values, which positions need.
  int add_bounded(const Rows& rows) {
    const int accessor = add_rows(rows);
    Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
    Eigen::Vector3f high = -low;
    for (const Eigen::Vector3d& row : rows) {
      low = low.cwiseMin(row.cast<float>());
      high = high.cwiseMax(row.cast<float>());
    }
    document_.accessors[accessor].minValues.assign(low.begin(), low.end());
    document_.accessors[accessor].maxValues.assign(high.begin(), high.end());
    return accessor;
  }

  int add_colors() {
    Rows colors;
    colors.reserve(model_.colors.size());
    for (const Eigen::Vector3d& color : model_.colors) colors.push_back(to_linear(color));
    return add_rows(colors);
  }

  int add_coordinates() {
    const std::size_t start = document_.buffers[0].data.size();
    for (const Eigen::Vector2d& place : split_.coordinates) {
      append_float(place.x());
      // glTF counts from the upper left corner of an image.
      append_float(1 - place.y());
    }
    return finish(start, TINYGLTF_TARGET_ARRAY_BUFFER, of_vertices(TINYGLTF_TYPE_VEC2));
  }

  int add_indices() {
    const std::size_t start = document_.buffers[0].data.size();
    for (const Face& face : split_.faces)
      for (const int vertex : face) append(static_cast<std::uint32_t>(vertex));
    tinygltf::Accessor accessor;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = 3 * split_.faces.size();
    return finish(start, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, std::move(accessor));
  }

  const Model& model_;
  const AtomicFile& file_;
  SplitVertices split_;
  tinygltf::Model document_;
};

}  // namespace

void write_glb_model(const Model& model, AtomicFile& file) {
  file.write(GltfWriter(model, file).write(Container::kGlb));
}

void write_gltf_model(const Model& model, AtomicFile& file) {
  file.write(GltfWriter(model, file).write(Container::kGltf));
}

void write_glb(const Mesh& mesh, AtomicFile& file) { write_glb_model({mesh, {}, {}, {}}, file); }

void write_gltf(const Mesh& mesh, AtomicFile& file) { write_gltf_model({mesh, {}, {}, {}}, file); }

}  // namespace isomatch::mesh_io
