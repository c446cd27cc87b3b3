// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "measure/fit_measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "isomatch/geodesics/geodesics.h"
#include "parallel.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {
namespace {

/// Evenly spread places around which distances are compared, on shapes with limbs .06 apart.
constexpr int kSamples = 300;
/// Those around a sample that it is compared with; 10 to 20 on flat parts.
constexpr float kReach = 0.15F;
/// Of these, those that global distances are measured between.
constexpr int kFarSamples = 100;
/// Heights are measured against a mean of this width.
constexpr float kReliefWidth = 0.05F;
/// Standard deviation of heights below which a surface is too even to tell places apart.
constexpr double kEven = 0.002;
/// What rounding to vertices may do to a distance.
constexpr float kNoise = 0.02F;
/// Images farther apart than this count as this far, which is torn in any case. Most are nearer
/// than the other, which takes a fraction of the time to find out.
constexpr float kFar = 0.7F, kNotFar = 2 * kReach;
/// Nearer than this to an image a point is reached.
constexpr float kReached = 0.05F;

/// A surface and its edges as a graph: distances up to a tenth too long do here.
struct Side {
  const Surface& surface;
  std::shared_ptr<const GeodesicGraph> graph;
};

Side side_of(const Shape& shape, const Context& context) {
  return {*shape.prepared().surface(), shape.prepared().graph(GeodesicOptions::edges(), context)};
}

/// Vertices of the source that have an image, and their images.
struct SampledImages {
  std::vector<int> vertices, targets;
};

SampledImages images_of(const OnSurface<VertexMap>& map) {
  SampledImages images;
  for (int v = 0; v < static_cast<int>(map->size()); ++v) {
    if ((*map)[v] == kUnmatched) continue;
    images.vertices.push_back(v);
    images.targets.push_back((*map)[v]);
  }
  return images;
}

/// Finds distances from one sample to others.
struct Finder {
  GeodesicSearch search;
  /// To all vertices; infinite between searches.
  std::vector<float> field;

  explicit Finder(const Side& side)
      : search(*side.graph),
        field(side.surface.mesh.num_vertices(), std::numeric_limits<float>::infinity()) {}

  /// To those of `samples` that are within `reach` of a vertex, infinite beyond, into `row`.
  void find(int from, const std::vector<int>& samples, float reach, std::span<float> row) {
    const auto reached = search.ball(from, reach);
    for (const auto& [vertex, distance] : reached) field[vertex] = distance;
    for (std::size_t j = 0; j < samples.size(); ++j) row[j] = field[samples[j]];
    for (const auto& [vertex, distance] : reached)
      field[vertex] = std::numeric_limits<float>::infinity();
  }
};

/// Distances between the samples (rows and columns) within `reach`, infinite beyond.
std::vector<float> distances_within(const Side& side, const std::vector<int>& samples, float reach,
                                    const Context& context) {
  const std::size_t count = samples.size();
  std::vector<float> rows(count * count);
  const auto make = [&] { return Finder(side); };
  parallel_for(std::ssize(samples), context, make, [&](Finder& finder, std::ptrdiff_t i) {
    finder.find(samples[i], samples, reach, std::span(rows).subspan(i * count, count));
  });
  return rows;
}

/// Distances between images of samples (rows and columns), of those that are finite in `near`; far
/// ones are infinite.
std::vector<float> distances_of_images(const Side& side, const std::vector<int>& images,
                                       const std::vector<float>& near, float not_far, float far,
                                       const Context& context) {
  const std::size_t count = images.size();
  std::vector<float> rows(count * count);
  const auto make = [&] { return Finder(side); };
  parallel_for(std::ssize(images), context, make, [&](Finder& finder, std::ptrdiff_t i) {
    const std::span<float> row = std::span(rows).subspan(i * count, count);
    finder.find(images[i], images, not_far, row);
    for (std::size_t j = 0; j < count; ++j) {
      if (std::isinf(near[i * count + j]) || !std::isinf(row[j])) continue;
      finder.find(images[i], images, far, row);
      return;
    }
  });
  return rows;
}

/// All distances between the samples (rows and columns).
std::vector<float> distances_between(const Side& side, const std::vector<int>& samples,
                                     const Context& context) {
  // Fields that are computed at a time, in so much memory.
  constexpr std::size_t kFloats = 16'000'000;
  const auto n = static_cast<std::size_t>(side.surface.mesh.num_vertices());
  const std::size_t at_a_time = std::max<std::size_t>(1, kFloats / n);
  std::vector<float> rows;
  for (std::size_t first = 0; first < samples.size(); first += at_a_time) {
    const std::span<const int> some =
        std::span(samples).subspan(first, std::min(at_a_time, samples.size() - first));
    const std::vector<float> fields = geodesic_fields(*side.graph, some, context);
    for (std::size_t i = 0; i < some.size(); ++i)
      for (const int sample : samples) rows.push_back(fields[i * n + sample]);
  }
  return rows;
}

/// For each sample the mean |log s| over those around it.
std::vector<double> stretch_around(const std::vector<float>& before,
                                   const std::vector<float>& after, std::size_t samples) {
  std::vector<double> stretch(samples, 0);
  for (std::size_t i = 0; i < samples; ++i) {
    double sum = 0;
    int count = 0;
    for (std::size_t k = i * samples; k < (i + 1) * samples; ++k) {
      if (k == i * samples + i || std::isinf(before[k])) continue;
      sum += std::abs(std::log((std::min(after[k], kFar) + kNoise) / (before[k] + kNoise)));
      ++count;
    }
    if (count > 0) stretch[i] = sum / count;
  }
  return stretch;
}

/// Those of the images that are evenly spread over the source.
SampledImages spread(const SampledImages& images, const Side& source, const Context& context) {
  SampledImages samples;
  for (int k : farthest_points(*source.graph, images.vertices, kSamples, 0, context)) {
    samples.vertices.push_back(images.vertices[k]);
    samples.targets.push_back(images.targets[k]);
  }
  return samples;
}

/// `near` are the distances between the samples on the source that are within reach.
void measure_stretch(const Side& target, const SampledImages& samples,
                     const std::vector<float>& near, double scale, const Context& context,
                     FitMeasures& measures) {
  // In the unit of the source.
  const auto unit = static_cast<float>(std::max(scale, 1.0));
  std::vector<float> images =
      distances_of_images(target, samples.targets, near, kNotFar * unit, kFar, context);
  for (float& distance : images) distance /= static_cast<float>(scale);
  const std::vector<double> stretch = stretch_around(near, images, samples.vertices.size());
  const auto count = static_cast<double>(stretch.size());
  measures.stretch = std::accumulate(stretch.begin(), stretch.end(), 0.0) / count;
  const auto is_distorted = [](double s) { return s > std::numbers::ln2; };
  measures.distorted = static_cast<double>(std::ranges::count_if(stretch, is_distorted)) / count;
}

double displacement(const Side& source, const Side& target, SampledImages samples,
                    const Context& context) {
  const std::size_t count = std::min<std::size_t>(samples.vertices.size(), kFarSamples);
  samples.vertices.resize(count);
  samples.targets.resize(count);
  const std::vector<float> before = distances_between(source, samples.vertices, context);
  const std::vector<float> after = distances_between(target, samples.targets, context);
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0;
    for (std::size_t k = i * count; k < (i + 1) * count; ++k) sum += std::abs(before[k] - after[k]);
    largest = std::max(largest, sum / static_cast<double>(count));
  }
  return largest;
}

/// How high each of `vertices` lies above the mean of the surface around it.
std::vector<double> heights(const Side& side, const std::vector<int>& vertices,
                            const Context& context) {
  std::vector<double> result(vertices.size());
  const auto make = [&] { return GeodesicSearch(*side.graph); };
  parallel_for(std::ssize(vertices), context, make, [&](GeodesicSearch& search, std::ptrdiff_t i) {
    Point mean(0, 0, 0), normal(0, 0, 0);
    double all = 0;
    for (const auto& [vertex, distance] : search.ball(vertices[i], 2 * kReliefWidth)) {
      const float widths = distance / kReliefWidth;
      const double weight = side.surface.vertex_areas[vertex] * std::exp(-widths * widths / 2);
      mean += weight * side.surface.mesh.vertices[vertex];
      normal += weight * side.surface.normals[vertex];
      all += weight;
    }
    if (all > 0)
      result[i] = normal.normalized().dot(side.surface.mesh.vertices[vertices[i]] - mean / all);
  });
  return result;
}

/// Subtracts the mean. Returns the standard deviation.
double centre(std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double sum = 0;
  for (double& value : values) {
    value -= mean;
    sum += value * value;
  }
  return std::sqrt(sum / count);
}

double relief_agreement(const Side& source, const Side& target, const SampledImages& samples,
                        const Context& context) {
  std::vector<double> before = heights(source, samples.vertices, context);
  std::vector<double> after = heights(target, samples.targets, context);
  const double deviations[] = {centre(before), centre(after)};
  if (deviations[0] < kEven || deviations[1] < kEven) return 1;
  return std::inner_product(before.begin(), before.end(), after.begin(), 0.0) /
         (static_cast<double>(before.size()) * deviations[0] * deviations[1]);
}

/// Share of the area that is farther from all of `vertices` than `limit`.
double share_beyond(const Side& side, const std::vector<int>& vertices, float limit) {
  const std::vector<float> distances =
      GeodesicSearch(*side.graph).nearest_source(vertices).distances;
  double beyond = 0;
  for (std::size_t v = 0; v < distances.size(); ++v)
    if (distances[v] > limit) beyond += side.surface.vertex_areas[v];
  return beyond;
}

/// What the turn from one neighbour to another looks like from above a place.
double sine(const Point& normal, const Point& a, const Point& b) {
  return normal.dot(a.normalized().cross(b.normalized()));
}

/// Sum, over all pairs of the neighbours of a sample, of the product of their sines before and
/// after: negative where most turns change their sense.
double turning(const Side& source, const Side& target, const SampledImages& samples, std::size_t at,
               const std::vector<int>& neighbours) {
  const auto towards = [&](const Side& side, const std::vector<int>& vertices, int neighbour) {
    return Point(side.surface.mesh.vertices[vertices[neighbour]] -
                 side.surface.mesh.vertices[vertices[at]]);
  };
  const Point& before = source.surface.normals[samples.vertices[at]];
  const Point& after = target.surface.normals[samples.targets[at]];
  double sum = 0;
  for (std::size_t k = 1; k < neighbours.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const auto seen = [&](const Side& side, const std::vector<int>& vertices,
                            const Point& normal) {
        return sine(normal, towards(side, vertices, neighbours[j]),
                    towards(side, vertices, neighbours[k]));
      };
      sum += seen(source, samples.vertices, before) * seen(target, samples.targets, after);
    }
  }
  return sum;
}

/// Share of the samples around which the map turns the surface over.
double reversed_share(const Side& source, const Side& target, const SampledImages& samples,
                      const std::vector<float>& near) {
  if (!source.surface.oriented || !target.surface.oriented) return -1;
  const std::size_t count = samples.vertices.size();
  int reversed = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<int> neighbours;
    for (std::size_t j = 0; j < count; ++j)
      if (j != i && !std::isinf(near[i * count + j]) && samples.targets[j] != samples.targets[i])
        neighbours.push_back(static_cast<int>(j));
    reversed += turning(source, target, samples, i, neighbours) < 0;
  }
  return static_cast<double>(reversed) / static_cast<double>(count);
}

}  // namespace

FitMeasures measure_fit(const Shape& source, const Shape& target, const OnSurface<VertexMap>& map,
                        double scale, const Context& context) {
  const Side from = side_of(source, context), onto = side_of(target, context);
  const SampledImages images = images_of(map);
  if (images.vertices.empty()) return {.unreached = 1, .unmatched = 1, .reversed = -1};
  FitMeasures measures;
  const SampledImages samples = spread(images, from, context);
  const std::vector<float> near = distances_within(from, samples.vertices, kReach, context);
  measure_stretch(onto, samples, near, scale, context, measures);
  measures.displacement = displacement(from, onto, samples, context);
  measures.relief = relief_agreement(from, onto, samples, context);
  // Of sparse maps and coarse meshes even neighbours are farther apart.
  const auto spacing =
      static_cast<float>(2 / std::sqrt(static_cast<double>(images.vertices.size())));
  const float limit = std::max(kReached, spacing);
  measures.unreached = share_beyond(onto, images.targets, limit);
  measures.unmatched = share_beyond(from, images.vertices, limit);
  measures.reversed = reversed_share(from, onto, samples, near);
  return measures;
}

}  // namespace isomatch
