// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/detail.h"

#include <algorithm>
#include <cmath>

#include "geometry/simplify.h"
#include "geometry/walk.h"
#include "parallel.h"
#include "tracked/shape/relief.h"

namespace isomatch::tracked {
namespace {

/// For each vertex the vertex of the detail from which the fewest edges lead there.
std::vector<int> fewest_edges_away(const Surface& surface, const Detail& detail) {
  std::vector<int> anchor(surface.mesh.vertices.size(), kNoVertex);
  std::vector<int> reached = detail.surface_vertex;
  reached.reserve(anchor.size());
  for (std::size_t d = 0; d < reached.size(); ++d) anchor[reached[d]] = static_cast<int>(d);
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int from = reached[next];
    for (int f : surface.faces[from]) {
      for (int v : surface.mesh.faces[f]) {
        if (anchor[v] != kNoVertex) continue;
        anchor[v] = anchor[from];
        reached.push_back(v);
      }
    }
  }
  return anchor;
}

}  // namespace

Detail make_detail(const PreparedShape& shape, const Surface& surface,
                   const PyramidOptions& options, const Context& context) {
  SimplifiedMesh simplified = simplify(surface.mesh, options.detail_vertices);
  const Mesh& mesh = simplified.mesh;
  std::vector<elastic::Features> features;
  for (const auto& relief : relief(mesh, unit_normals(mesh), options.relief_scales))
    features.push_back({relief, {}});
  IndexLists faces = vertex_faces(mesh);
  const bool is_whole =
      mesh.num_vertices() == surface.num_vertices() && surface.scale == shape.surface()->scale;
  // A mirror image has the distances of what it mirrors.
  auto graph = is_whole ? shape.graph({}, context)
                        : std::make_shared<const GeodesicGraph>(mesh, GeodesicOptions{}, context);
  return {std::move(simplified.mesh), std::move(simplified.kept), std::move(faces),
          std::move(features), std::move(graph)};
}

void set_places(Detail& detail, const std::vector<int>& vertices, const Context& context) {
  const std::vector<float> fields = geodesic_fields(*detail.graph, vertices, context);
  const std::size_t n = detail.features.size();
  float longest = 0;  // What is not connected is as far as what is farthest.
  for (const float d : fields)
    if (std::isfinite(d)) longest = std::max(longest, d);
  for (std::size_t k = 0; k < vertices.size(); ++k)
    for (std::size_t v = 0; v < n; ++v)
      detail.features[v].place[k] = std::min(fields[k * n + v], longest);
}

std::vector<int> anchors(const Surface& surface, const Detail& detail, const Context& context) {
  std::vector<int> anchor = fewest_edges_away(surface, detail);
  parallel_for(std::ssize(anchor), context, [&](std::ptrdiff_t v) {
    anchor[v] = walk_to_vertex(detail.mesh, detail.faces, anchor[v], surface.mesh.vertices[v]);
  });
  return anchor;
}

}  // namespace isomatch::tracked
