// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/shape/contacts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "geometry/handle_loop.h"
#include "geometry/simplify.h"
#include "parallel.h"

namespace isomatch::tracked {
namespace {

using Loop = HandleLoops::Loop;

/// What it costs to go along each vertex: the less, the deeper its valley.
std::vector<double> valley_weights(const Detail& detail, const ContactOptions& options) {
  std::vector<double> weights;
  for (const elastic::Features& features : detail.features)
    weights.push_back(std::exp(std::min(0.0, features.relief[0] / options.valley)));
  return weights;
}

/// At least `count` of them if there are as many.
std::vector<int> some_of(const std::vector<int>& vertices, int count) {
  std::vector<int> some;
  const std::size_t step = std::max<std::size_t>(1, vertices.size() / count);
  for (std::size_t k = 0; k < vertices.size(); k += step) some.push_back(vertices[k]);
  return some;
}

/// Some vertices of a mesh, evenly spread over those in the deepest valleys.
std::vector<int> valley_roots(const Mesh& mesh, const std::vector<double>& weights,
                              const std::vector<bool>& removed, const ContactOptions& options) {
  std::vector<int> vertices;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (!removed[v]) vertices.push_back(v);
  std::ranges::stable_sort(vertices, {}, [&](int v) { return weights[v]; });
  vertices.resize(
      static_cast<std::size_t>(options.valley_share * static_cast<double>(vertices.size())));
  return some_of(vertices, options.roots);
}

Mesh remaining(const Mesh& mesh, const std::vector<bool>& removed) {
  Mesh result{mesh.vertices, {}};
  for (const Face& face : mesh.faces)
    if (std::ranges::none_of(face, [&](int v) { return removed[v]; })) result.faces.push_back(face);
  return result;
}

/// The cheapest loops, each after what those before have cut.
std::vector<Loop> successive_loops(const Mesh& mesh, const std::vector<double>& weights,
                                   const ContactOptions& options, const Context& context) {
  std::vector<Loop> loops;
  std::vector<bool> removed(mesh.vertices.size(), false);
  while (std::cmp_less(loops.size(), options.most_handles)) {
    context.check_stop();
    const Mesh rest = remaining(mesh, removed);
    const HandleLoops handles(rest, weights);
    if (handles.num_handles() == 0) break;
    Loop loop = handles.cheapest(valley_roots(rest, weights, removed, options));
    const std::vector<int> roots = some_of(loop.vertices, options.closer_roots);
    if (Loop better = handles.cheapest(roots); better.cost < loop.cost) loop = std::move(better);
    if (loop.vertices.empty() || loop.cost > options.max_cost) break;
    for (const int v : loop.vertices) removed[v] = true;
    loops.push_back(std::move(loop));
  }
  return loops;
}

double length(const Mesh& mesh, const Loop& loop) {
  double sum = 0;
  int before = loop.vertices.back();
  for (const int v : loop.vertices)
    sum += (mesh.vertices[v] - mesh.vertices[std::exchange(before, v)]).norm();
  return sum;
}

/// The loops have no vertex in common.
Cut cut_along(const Detail& detail, const std::vector<Loop>& loops) {
  Cut cut;
  for (const Loop& loop : loops)
    for (const int v : loop.vertices) cut.push_back(detail.surface_vertex[v]);
  std::ranges::sort(cut);
  return cut;
}

/// Makes everything close to a loop dear.
void avoid(const Mesh& mesh, const Loop& loop, const ContactOptions& options,
           std::vector<double>& weights) {
  constexpr double kDear = 100;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    if (std::ranges::any_of(loop.vertices, [&](int l) {
          return (mesh.vertices[l] - mesh.vertices[v]).norm() < options.avoided;
        }))
      weights[v] = kDear;
}

}  // namespace

Cut united(const Cut& a, const Cut& b) {
  Cut both;
  std::ranges::set_union(a, b, std::back_inserter(both));
  return both;
}

std::vector<Cut> possible_cuts(const Detail& detail, const ContactOptions& options,
                               const Context& context) {
  const std::vector<double> weights = valley_weights(detail, options);
  const int handles = HandleLoops(detail.mesh, weights).num_handles();
  if (handles == 0 || handles > options.most_handles) return {};
  const std::vector<Loop> loops = successive_loops(detail.mesh, weights, options, context);
  std::vector<Loop> doubtful;
  for (const Loop& loop : loops)
    if (length(detail.mesh, loop) > options.short_loop) doubtful.push_back(loop);
  std::vector<Cut> cuts(doubtful.size() + 1);
  cuts.front() = cut_along(detail, loops);
  parallel_for(std::ssize(doubtful), context, [&](std::ptrdiff_t k) {
    std::vector<double> dearer = weights;
    avoid(detail.mesh, doubtful[k], options, dearer);
    cuts[k + 1] = cut_along(detail, successive_loops(detail.mesh, dearer, options, context));
  });
  std::erase(cuts, Cut());
  return cuts;
}

Detail without(const Detail& detail, const Cut& cut, const Context& context) {
  std::vector<bool> removed(detail.mesh.vertices.size(), false);
  for (std::size_t v = 0; v < removed.size(); ++v)
    removed[v] = std::ranges::binary_search(cut, detail.surface_vertex[v]);
  SimplifiedMesh rest = without_unused_vertices(remaining(detail.mesh, removed));
  Detail result;
  result.mesh = std::move(rest.mesh);
  for (const int v : rest.kept) {
    result.surface_vertex.push_back(detail.surface_vertex[v]);
    result.features.push_back(detail.features[v]);
  }
  result.faces = vertex_faces(result.mesh);
  result.graph = std::make_shared<const GeodesicGraph>(result.mesh, GeodesicOptions{}, context);
  return result;
}

}  // namespace isomatch::tracked
