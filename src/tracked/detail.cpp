// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/detail.h"

#include <algorithm>

#include "elastic/descent.h"
#include "tracked/relief.h"
#include "tracked/simplify.h"

namespace isomatch::tracked {
namespace {

/// For each vertex the vertex of the detail from which the fewest edges lead there.
std::vector<int> anchors(const UnitSurface& surface, const Detail& detail) {
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

elastic::Features interpolated(const Detail& detail, const elastic::Foot& foot) {
  elastic::Features result;
  const Face& face = detail.mesh.faces[foot.face];
  for (int corner = 0; corner < 3; ++corner) {
    const elastic::Features& features = detail.features[face[corner]];
    for (int k = 0; k < elastic::kReliefs; ++k)
      result.relief[k] += foot.weights[corner] * features.relief[k];
    for (int k = 0; k < elastic::kPlaces; ++k)
      result.place[k] += foot.weights[corner] * features.place[k];
  }
  return result;
}

}  // namespace

Detail make_detail(const UnitSurface& surface, int vertices, const Context& context) {
  SimplifiedMesh simplified = simplify(surface.mesh, vertices);
  const Mesh& mesh = simplified.mesh;
  std::vector<elastic::Features> features;
  for (const auto& relief : relief(mesh, unit_normals(mesh))) features.push_back({relief, {}});
  IndexLists faces = vertex_faces(mesh);
  GeodesicGraph graph(mesh, {}, context);
  return {std::move(simplified.mesh), std::move(simplified.kept), std::move(faces),
          std::move(features), std::move(graph)};
}

void set_places(Detail& detail, const std::vector<int>& vertices, const Context& context) {
  const std::vector<float> fields = geodesic_fields(detail.graph, vertices, context);
  const std::size_t n = detail.features.size();
  for (std::size_t k = 0; k < vertices.size(); ++k)
    for (std::size_t v = 0; v < n; ++v) detail.features[v].place[k] = fields[k * n + v];
}

Attachment attach(const UnitSurface& surface, const Detail& detail, const Context& context) {
  Attachment result{anchors(surface, detail), {}};
  result.features.resize(result.anchors.size());
  const std::vector<Point> no_normals(detail.mesh.vertices.size(), Point::Zero());
  const elastic::Descent descent(detail.mesh, detail.faces, no_normals, detail.features,
                                 {.normal = 0, .relief = 0, .place = 0});
#pragma omp parallel for schedule(static) num_threads(context.threads)
  for (std::size_t v = 0; v < result.anchors.size(); ++v) {
    const Point& p = surface.mesh.vertices[v];
    int& anchor = result.anchors[v];
    anchor = descent.nearest_vertex(anchor, p, Point::Zero(), {});
    result.features[v] = interpolated(
        detail, elastic::foot_around(anchor, p, detail.mesh, detail.faces, no_normals));
  }
  return result;
}

}  // namespace isomatch::tracked
