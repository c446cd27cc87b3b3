// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "carry/charts.h"
#include "carry/seam_cutter.h"
#include "geometry/walk.h"
#include "isomatch/carry/texture_transfer.h"
#include "isomatch/error.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

/// Numbers the coordinates at each vertex, equal ones once.
class CoordinateList {
 public:
  explicit CoordinateList(std::vector<Eigen::Vector2d>& list) : list_(list) {}

  int number_of(int vertex, const Eigen::Vector2d& coordinates) {
    const auto [entry, is_new] = numbers_.try_emplace({vertex, coordinates.x(), coordinates.y()},
                                                      static_cast<int>(list_.size()));
    if (is_new) list_.push_back(coordinates);
    return entry->second;
  }

 private:
  std::vector<Eigen::Vector2d>& list_;
  std::map<std::tuple<int, double, double>, int> numbers_;
};

class TextureCarrier {
 public:
  TextureCarrier(const transfer::Charts& charts, const Texture& texture,
                 const transfer::MappedMesh& target)
      : charts_(charts), texture_(texture), target_(target), list_(result_.coordinates) {}

  Texture run() {
    result_.materials = texture_.materials;
    for (const Face& face : target_.mesh.faces) carry(face);
    return std::move(result_);
  }

 private:
  void carry(const Face& face) {
    result_.corners.push_back({Texture::kNone, Texture::kNone, Texture::kNone});
    result_.face_material.push_back(Texture::kNone);
    const auto unmatched = [&](int v) { return target_.map[v].face == kNoFace; };
    if (std::ranges::any_of(face, unmatched)) return;
    std::array<Point, 3> places;
    std::array<int, 3> starts;
    for (int k = 0; k < 3; ++k) {
      places[k] = position(charts_.mesh(), target_.map[face[k]]);
      starts[k] = target_.map[face[k]].face;
    }
    const Point centre = (places[0] + places[1] + places[2]) / 3;
    const int middle = walk_to_point(charts_.mesh(), charts_.vertex_faces(), starts, centre).face;
    if (!texture_.covers(middle)) return;
    result_.face_material.back() = texture_.face_material[middle];
    const std::vector<int> side = charts_.grow(std::array{middle}, ball_around(centre, places));
    for (int k = 0; k < 3; ++k)
      result_.corners.back()[k] = list_.number_of(
          face[k],
          charts_.coordinates(transfer::nearest_point(charts_.mesh(), side, places[k]).point));
  }

  /// Wide enough for the surface between the corners, which may bulge, and no wider: around a thin
  /// limb it would lead to the corners beyond a seam from behind.
  static transfer::Ball ball_around(const Point& centre, const std::array<Point, 3>& corners) {
    constexpr double kBulge = 1.2;
    double radius = 0;
    for (const Point& corner : corners) radius = std::max(radius, (corner - centre).norm());
    return {centre, kBulge * radius};
  }

  const transfer::Charts& charts_;
  const Texture& texture_;
  const transfer::MappedMesh& target_;
  Texture result_;
  CoordinateList list_;
};

void check_indices(std::span<const int> indices, std::size_t size, const char* name) {
  for (int index : indices)
    if (index < Texture::kNone || (index >= 0 && std::cmp_greater_equal(index, size)))
      throw InvalidInput(fmt::format("the texture's {} {} is out of range", name, index));
}

}  // namespace

void validate(const Texture& texture, const Mesh& mesh) {
  if (texture.corners.size() != mesh.faces.size() ||
      texture.face_material.size() != mesh.faces.size())
    throw InvalidInput(fmt::format("the texture is that of {} faces, but the mesh has {}",
                                   texture.corners.size(), mesh.num_faces()));
  for (const auto& corners : texture.corners) {
    check_indices(corners, texture.coordinates.size(), "coordinate");
    const auto missing = std::ranges::count(corners, Texture::kNone);
    if (missing != 0 && missing != 3)
      throw InvalidInput("a face has texture coordinates at some of its corners only");
  }
  check_indices(texture.face_material, texture.materials.size(), "material");
  if (!std::ranges::all_of(texture.coordinates, [](const auto& p) { return p.allFinite(); }))
    throw InvalidInput("a texture coordinate is not finite");
}

TexturedMesh transfer_texture(const Mesh& source, const Texture& texture, const Mesh& target,
                              const SurfaceMap& target_to_source,
                              const TextureTransferOptions& options) {
  validate(texture, source);
  check_map(target_to_source, target.num_vertices(), source.num_faces());
  const transfer::Charts charts(source, texture);
  transfer::MappedMesh mapped = options.cut_seams
                                    ? cut_along_seams(charts, target, target_to_source)
                                    : transfer::MappedMesh{target, target_to_source};
  Texture carried = TextureCarrier(charts, texture, mapped).run();
  return {std::move(mapped.mesh), std::move(carried)};
}

}  // namespace isomatch
