// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/holes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "isomatch/error.h"
#include "isomatch/geodesics/geodesics.h"
#include "isomatch/maps/correspondence.h"
#include "synth/remains.h"

namespace isomatch::synth {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

std::vector<int> border(const Mesh& mesh) {
  const std::vector<int> open = open_edges(mesh);
  std::vector<int> vertices;
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    if (open[v] > 0) vertices.push_back(v);
  }
  return vertices;
}

/// Finds room for one hole after the other.
class HolePlaces {
 public:
  HolePlaces(const Mesh& mesh, double radius, const Context& context)
      : graph_(mesh, {}, context),
        search_(graph_),
        radius_(static_cast<float>(radius)),
        to_middle_(mesh.vertices.size(), kFar),
        taken_(mesh.vertices.size()) {
    const std::vector<int> open = border(mesh);
    if (open.empty()) return;
    const std::vector<float> distances = search_.nearest_source(open).distances;
    std::transform(distances.begin(), distances.end(), taken_.begin(),
                   [&](float distance) { return distance <= 2 * radius_; });
  }

  /// Takes the place around `middle` for a hole; false if it is not free.
  bool add(int middle) {
    if (taken_[middle]) return false;
    for (const auto& [vertex, distance] : search_.ball(middle, 2 * radius_))
      to_middle_[vertex] = std::min(to_middle_[vertex], distance);
    for (const auto& reached : search_.ball(middle, 3 * radius_)) taken_[reached.vertex] = true;
    return true;
  }

  /// Whether the face is in a hole, by the mean of its corners, which makes holes neither larger
  /// nor smaller than the radius.
  bool in_hole(const Face& face) const {
    return to_middle_[face[0]] + to_middle_[face[1]] + to_middle_[face[2]] <= 3 * radius_;
  }

 private:
  GeodesicGraph graph_;
  GeodesicSearch search_;
  float radius_;
  std::vector<float> to_middle_;  ///< Of the nearest hole, `kFar` where none is near.
  std::vector<bool> taken_;
};

}  // namespace

Mesh make_holes(Mesh mesh, HoleOptions options, Random& random, const Context& context) {
  HolePlaces places(mesh, options.radius, context);
  random.shuffle(options.middles);
  int made = 0;
  for (int middle : options.middles) {
    if (made == options.count) break;
    if (middle != kUnmatched && places.add(middle)) ++made;
  }
  if (made < options.count)
    throw InvalidInput(fmt::format("there is room for {} holes, not {}", made, options.count));
  std::erase_if(mesh.faces, [&](const Face& face) { return places.in_hole(face); });
  return mesh;
}

}  // namespace isomatch::synth
