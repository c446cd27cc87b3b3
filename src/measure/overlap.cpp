// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/measure/overlap.h"

#include <algorithm>

#include "isomatch/mesh/topology.h"
#include "measure/surface_errors.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {
namespace {

/// Each vertex of a surface as a point; all of them have a face.
SurfacePoint corner_point(const Surface& surface, int vertex) {
  SurfacePoint point{surface.faces[vertex].front(), {}};
  const Face& face = surface.mesh.faces[point.face];
  point.weights[std::ranges::find(face, vertex) - face.begin()] = 1;
  return point;
}

SurfaceMap true_points(const Surface& source, const Surface& target, const VertexMap& truth) {
  SurfaceMap points;
  for (const int vertex : *on_surfaces(source, target, truth))
    points.push_back(vertex == kNoVertex ? SurfacePoint{} : corner_point(target, vertex));
  return points;
}

SurfaceMap true_points(const Surface& source, const Surface& target, const SurfaceMap& truth) {
  return *on_surfaces(source, target, truth);
}

/// In the numbers of the surfaces.
SurfaceMap true_points(const Surface& source, const Surface& target, const TrueMap& truth) {
  return std::visit([&](const auto& map) { return true_points(source, target, map); }, truth);
}

/// Where a map leads, as points on the target's surface, by vertices of the source's.
class MapImages {
 public:
  MapImages(const Surface& source, const Surface& target, const Correspondence& matches)
      : target_(target), matches_(*on_surfaces(source, target, matches)) {}
  MapImages(const Surface& source, const Surface& target, const SurfaceMap& map)
      : target_(target), points_(*on_surfaces(source, target, map)) {}

  bool has(int vertex) const {
    return points_.empty() ? !matches_of(matches_, vertex).empty()
                           : points_[vertex].face != kNoFace;
  }
  template <class Visit>
  void for_each(int vertex, const Visit& visit) const {
    for (const Match& match : matches_of(matches_, vertex))
      visit(corner_point(target_, match.target));
    if (!points_.empty() && has(vertex)) visit(points_[vertex]);
  }

 private:
  const Surface& target_;
  Correspondence matches_;
  SurfaceMap points_;
};

/// Sums of weights, as shares at the end.
class Counter {
 public:
  void add(bool matched, bool truly, double weight) {
    double& share = matched ? (truly ? sums_.both : sums_.only_matched)
                            : (truly ? sums_.only_true : sums_.neither);
    share += weight;
  }
  OverlapQuality shares() const {
    const auto& [both, only_matched, only_true, neither] = sums_;
    const double all = both + only_matched + only_true + neither;
    if (all == 0) return {};
    return {both / all, only_matched / all, only_true / all, neither / all};
  }

 private:
  OverlapQuality sums_;
};

template <class Map>
OverlapQuality quality(const Shape& source_shape, const Shape& target_shape, const TrueMap& truth,
                       const Map& map) {
  const Surface& source = *source_shape.prepared().surface();
  const Surface& target = *target_shape.prepared().surface();
  const SurfaceMap true_places = true_points(source, target, truth);
  const MapImages images(source, target, map);
  Counter counter;
  for (int v = 0; v < source.num_vertices(); ++v)
    counter.add(images.has(v), true_places[v].face != kNoFace, source.vertex_areas[v]);
  return counter.shares();
}

template <class Map>
OverlapQuality quality(const Shape& source_shape, const Shape& target_shape,
                       const GroundTruth& truth, const Map& map) {
  check_truth(truth);
  const Surface& source = *source_shape.prepared().surface();
  const Surface& target = *target_shape.prepared().surface();
  const MapImages images(source, target, map);
  Counter counter;
  for (int i = 0; i < truth.size(); ++i) {
    const int s = surface_place(source, truth.source[i]);
    const int t = surface_place(target, truth.target[i]);
    if (s != kNoVertex) counter.add(images.has(s), t != kNoVertex, 1);
  }
  return counter.shares();
}

/// What is measured on the overlap: pairs of points, and the source vertex of each.
struct OverlapPairs {
  std::vector<TwoPoints> pairs;
  std::vector<int> vertices;
};

OverlapPairs overlap_pairs(const SurfaceMap& true_places, const MapImages& images) {
  OverlapPairs result;
  for (int v = 0; v < std::ssize(true_places); ++v) {
    if (true_places[v].face == kNoFace) continue;
    images.for_each(v, [&](const SurfacePoint& mapped) {
      result.pairs.push_back({true_places[v], mapped});
      result.vertices.push_back(v);
    });
  }
  return result;
}

template <class Map>
OverlapPairs overlap_pairs(const Surface& source, const Surface& target, const TrueMap& truth,
                           const Map& map) {
  return overlap_pairs(true_points(source, target, truth), MapImages(source, target, map));
}

template <class Map>
OverlapErrors errors(const Shape& source_shape, const Shape& target_shape, const TrueMap& truth,
                     const Map& map, const TruthOptions& options, const Context& context) {
  options.validate();
  const Surface& source = *source_shape.prepared().surface();
  const MetricSurface target = target_shape.prepared().metric(context);
  const OverlapPairs overlap = overlap_pairs(source, target.surface(), truth, map);
  const std::vector<double> errors =
      distances(target, evenly_thinned(overlap.pairs, options.max_samples), context);
  return {error_statistics(errors, 1), error_statistics(errors, target.max_geodesic())};
}

template <class Map>
std::vector<double> mean_errors(const Shape& source_shape, const Shape& target_shape,
                                const TrueMap& truth, const Map& map, const Context& context) {
  const Surface& source = *source_shape.prepared().surface();
  const MetricSurface target = target_shape.prepared().metric(context);
  const auto [pairs, vertices] = overlap_pairs(source, target.surface(), truth, map);
  const std::vector<double> errors = distances(target, pairs, context);
  VertexMeans means(source);
  for (std::size_t i = 0; i < errors.size(); ++i) means.add(vertices[i], errors[i]);
  return means.means();
}

std::optional<double> share(double part, double rest) {
  if (part + rest == 0) return std::nullopt;
  return part / (part + rest);
}

}  // namespace

std::optional<double> OverlapQuality::iou() const { return share(both, only_matched + only_true); }

std::optional<double> OverlapQuality::unmatched_precision() const {
  return share(neither, only_true);
}

std::optional<double> OverlapQuality::unmatched_recall() const {
  return share(neither, only_matched);
}

OverlapQuality overlap_quality(const Shape& source, const Shape& target, const TrueMap& truth,
                               const Correspondence& matches) {
  return quality(source, target, truth, matches);
}

OverlapQuality overlap_quality(const Shape& source, const Shape& target, const TrueMap& truth,
                               const SurfaceMap& map) {
  return quality(source, target, truth, map);
}

OverlapQuality overlap_quality(const Shape& source, const Shape& target, const GroundTruth& truth,
                               const Correspondence& matches) {
  return quality(source, target, truth, matches);
}

OverlapQuality overlap_quality(const Shape& source, const Shape& target, const GroundTruth& truth,
                               const SurfaceMap& map) {
  return quality(source, target, truth, map);
}

OverlapErrors overlap_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                             const Correspondence& matches, const TruthOptions& options,
                             const Context& context) {
  return errors(source, target, truth, matches, options, context);
}

OverlapErrors overlap_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                             const SurfaceMap& map, const TruthOptions& options,
                             const Context& context) {
  return errors(source, target, truth, map, options, context);
}

std::vector<double> vertex_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                                  const Correspondence& matches, const Context& context) {
  return mean_errors(source, target, truth, matches, context);
}

std::vector<double> vertex_errors(const Shape& source, const Shape& target, const TrueMap& truth,
                                  const SurfaceMap& map, const Context& context) {
  return mean_errors(source, target, truth, map, context);
}

}  // namespace isomatch
