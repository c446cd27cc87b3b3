// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "group/places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "geometry/carried_point.h"
#include "geometry/walk.h"
#include "isomatch/mesh/topology.h"
#include "parallel.h"

namespace isomatch::group {
namespace {

CarriedPoint image_of(const Mesh& from, const Mesh& onto, const SurfaceMap& map,
                      const SurfacePoint& point) {
  return carried_point(from, map, point, [&](int vertex) { return position(onto, map[vertex]); });
}

SurfacePoint on_surface(const Surface& surface, const CarriedPoint& image, const Point& position) {
  return walk_to_point(surface.mesh, surface.faces, image.faces, position);
}

}  // namespace

struct Said {
  CarriedPoint image;
  double weight;
};

namespace {

/// The image with the least weighted sum of distances to the others.
const Said& medoid(const std::vector<Said>& said) {
  const Said* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Said& candidate : said) {
    double sum = 0;
    for (const Said& other : said)
      sum += other.weight * (candidate.image.position - other.image.position).norm();
    if (best != nullptr && sum >= least) continue;
    best = &candidate;
    least = sum;
  }
  return *best;
}

/// Weiszfeld's algorithm, from the medoid on.
Point geometric_median(const std::vector<Said>& said, Point median) {
  // Images that are nearer than maps are exact count alike; a few steps come that near.
  constexpr double kExact = 0.003;
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) {
    Point sum(0, 0, 0);
    double all = 0;
    for (const Said& one : said) {
      const double weight = one.weight / std::max((one.image.position - median).norm(), kExact);
      sum += weight * one.image.position;
      all += weight;
    }
    median = sum / all;
  }
  return median;
}

}  // namespace

MapGraph::MapGraph(std::vector<const Surface*> surfaces, const std::vector<WeightedMap>& maps)
    : surfaces_(std::move(surfaces)), onto_(surfaces_.size()) {
  for (const WeightedMap& map : maps) onto_[map.onto].push_back(map);
}

Places MapGraph::carried(const Places& places, int from, int onto, const SurfaceMap& map) const {
  Places result;
  result.reserve(places.size());
  for (const SurfacePoint& place : places) {
    const CarriedPoint image = image_of(surfaces_[from]->mesh, surfaces_[onto]->mesh, map, place);
    result.push_back(image.exists() ? on_surface(*surfaces_[onto], image, image.position)
                                    : SurfacePoint());
  }
  return result;
}

std::vector<Places> MapGraph::followed_from(int template_shape) const {
  std::vector<std::vector<WeightedMap>> from(surfaces_.size());
  for (const auto& maps : onto_)
    for (const WeightedMap& map : maps) from[map.from].push_back(map);
  const Mesh& mesh = surfaces_[template_shape]->mesh;
  std::vector<Places> places(surfaces_.size(), Places(mesh.vertices.size()));
  std::vector<double> variance(surfaces_.size(), std::numeric_limits<double>::infinity());
  using Waiting = std::pair<double, int>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
  places[template_shape] = corner_points(mesh);
  variance[template_shape] = 0;
  queue.emplace(0, template_shape);
  while (!queue.empty()) {
    const auto [reached, shape] = queue.top();
    queue.pop();
    if (reached > variance[shape]) continue;
    for (const WeightedMap& map : from[shape]) {
      const double longer = reached + 1 / map.weight;
      if (longer >= variance[map.onto]) continue;
      variance[map.onto] = longer;
      places[map.onto] = carried(places[shape], shape, map.onto, *map.map);
      queue.emplace(longer, map.onto);
    }
  }
  return places;
}

std::vector<Said> MapGraph::said_of(const std::vector<Places>& places, int shape, int point) const {
  std::vector<Said> said;
  double missing = 0, there = 0;
  for (const WeightedMap& map : onto_[shape]) {
    const SurfacePoint& place = places[map.from][point];
    if (place.face == kNoFace) continue;
    const CarriedPoint image =
        image_of(surfaces_[map.from]->mesh, surfaces_[shape]->mesh, *map.map, place);
    (image.exists() ? there : missing) += map.weight;
    if (image.exists()) said.push_back({image, map.weight});
  }
  if (missing > there) said.clear();
  return said;
}

Places MapGraph::agreed(const std::vector<Places>& places, int shape) const {
  Places result(places[shape].size());
  for (int p = 0; std::cmp_less(p, result.size()); ++p) {
    const std::vector<Said> said = said_of(places, shape, p);
    if (said.empty()) continue;
    const Said& central = medoid(said);
    result[p] = on_surface(*surfaces_[shape], central.image,
                           geometric_median(said, central.image.position));
  }
  return result;
}

void MapGraph::agree(std::vector<Places>& places, int template_shape, int rounds,
                     const Context& context) const {
  for (int round = 0; round < rounds; ++round) {
    std::vector<Places> next(places.size());
    parallel_for(std::ssize(places), context, [&](std::ptrdiff_t k) {
      const int shape = static_cast<int>(k);
      next[k] = shape == template_shape ? places[k] : agreed(places, shape);
    });
    places = std::move(next);
  }
}

std::vector<float> MapGraph::spread(const std::vector<Places>& places, int shape) const {
  std::vector<float> result(places[shape].size(), 0.0F);
  for (int p = 0; std::cmp_less(p, result.size()); ++p) {
    if (places[shape][p].face == kNoFace) continue;
    const Point here = position(surfaces_[shape]->mesh, places[shape][p]);
    double sum = 0, weights = 0;
    for (const Said& said : said_of(places, shape, p)) {
      sum += said.weight * (said.image.position - here).squaredNorm();
      weights += said.weight;
    }
    if (weights > 0) result[p] = static_cast<float>(std::sqrt(sum / weights));
  }
  return result;
}

double MapGraph::disagreement(const std::vector<Places>& places, int from, int onto,
                              const SurfaceMap& map) const {
  double sum = 0;
  int count = 0;
  for (std::size_t p = 0; p < places[from].size(); ++p) {
    if (places[onto][p].face == kNoFace) continue;
    const CarriedPoint image =
        image_of(surfaces_[from]->mesh, surfaces_[onto]->mesh, map, places[from][p]);
    if (!image.exists()) continue;
    sum += (image.position - position(surfaces_[onto]->mesh, places[onto][p])).norm();
    ++count;
  }
  return count == 0 ? std::numeric_limits<double>::infinity() : sum / count;
}

}  // namespace isomatch::group
