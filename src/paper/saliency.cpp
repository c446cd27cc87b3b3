// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "paper/saliency.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/cotangent_laplacian.h"
#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"
#include "parallel.h"
#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {
namespace {

std::vector<bool> open_vertices(const Mesh& mesh) {
  std::vector<bool> open(mesh.vertices.size(), false);
  const auto neighbours = face_neighbours(mesh);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      if (neighbours[f][corner] != kNoFace) continue;
      open[mesh.faces[f][(corner + 1) % 3]] = true;
      open[mesh.faces[f][(corner + 2) % 3]] = true;
    }
  }
  return open;
}

/// Integral of the Gaussian curvature over the cell of each vertex.
std::vector<double> angle_defects(const Mesh& mesh) {
  std::vector<double> defects(mesh.vertices.size(), 2 * std::numbers::pi);
  for (const Face& face : mesh.faces) {
    for (int corner = 0; corner < 3; ++corner)
      defects[face[corner]] -= corner_angle(mesh, face, corner);
  }
  const std::vector<bool> open = open_vertices(mesh);
  for (std::size_t v = 0; v < defects.size(); ++v) {
    if (open[v]) defects[v] = 0;
  }
  return defects;
}

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Heat flow for `time` from `values`, in three implicit steps.
Eigen::VectorXd diffuse(const Mesh& mesh, const Eigen::VectorXd& areas, Eigen::VectorXd values,
                        double time) {
  constexpr int kSteps = 3;
  if (time == 0) return values;
  SparseMatrix system = cotangent_laplacian(mesh) * (time / kSteps);
  system.diagonal() += areas;
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(system);
  solver.setTolerance(1e-8);
  for (int step = 0; step < kSteps; ++step)
    values = solver.solveWithGuess(areas.cwiseProduct(values), values);
  return values;
}

/// A vertex that does not depend on how they are numbered, which follows from the position of the
/// shape in space: the farthest from that of largest area.
int extremity(const MetricSurface& shape) {
  const auto largest = std::ranges::max_element(shape.vertex_areas());
  std::vector<float> distances(shape.num_vertices());
  GeodesicSearch(shape.graph())
      .field(static_cast<int>(largest - shape.vertex_areas().begin()), distances);
  return static_cast<int>(std::ranges::max_element(distances) - distances.begin());
}

std::vector<double> partition_areas(const MetricSurface& shape, std::span<const int> sources) {
  const SourcePartition partition = GeodesicSearch(shape.graph()).nearest_source(sources);
  std::vector<double> areas(sources.size(), 0.0);
  for (int v = 0; v < shape.num_vertices(); ++v)
    areas[partition.nearest[v]] += shape.vertex_areas()[v];
  return areas;
}

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void SaliencyOptions::validate() const {
  if (integral_points < 1) throw InvalidInput("integral_points must be at least 1");
  if (!(curvature_scale >= 0 && curvature_scale <= 1))
    throw InvalidInput("curvature_scale must be in [0, 1]");
}

std::vector<double> integral_geodesic_distance(const MetricSurface& shape,
                                               const SaliencyOptions& options,
                                               const Context& context) {
  options.validate();
  std::vector<int> vertices(shape.num_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  const std::vector<int> points =
      farthest_points(shape.graph(), vertices, options.integral_points, extremity(shape), context);
  const std::vector<double> weights = partition_areas(shape, points);
  const std::vector<float> fields = geodesic_fields(shape.graph(), points, context);
  const int n = shape.num_vertices();
  const double scale = 1 / shape.max_geodesic();
  std::vector<double> integral(n);
  parallel_for(n, context, [&](std::ptrdiff_t v) {
    double sum = 0;
    for (std::size_t p = 0; p < points.size(); ++p) sum += weights[p] * fields[p * n + v];
    integral[v] = sum * scale;
  });
  return integral;
}

std::vector<double> gaussian_curvature(const MetricSurface& shape, const SaliencyOptions& options) {
  options.validate();
  const std::vector<double> defects = angle_defects(shape.mesh());
  const int n = shape.num_vertices();
  Eigen::VectorXd areas = Eigen::Map<const Eigen::VectorXd>(shape.vertex_areas().data(), n);
  Eigen::VectorXd curvature = Eigen::Map<const Eigen::VectorXd>(defects.data(), n);
  curvature.array() /= areas.array();
  const double variance = std::pow(options.curvature_scale, 2);
  curvature = diffuse(shape.mesh(), areas, curvature, variance / 2);
  return {curvature.begin(), curvature.end()};
}

std::vector<double> integral_geodesic_distance(const Shape& shape, const SaliencyOptions& options,
                                               const Context& context) {
  const MetricSurface metric = shape.prepared().metric(context);
  return at_input(metric.surface(), integral_geodesic_distance(metric, options, context), kNoValue);
}

std::vector<double> gaussian_curvature(const Shape& shape, const SaliencyOptions& options,
                                       const Context& context) {
  const MetricSurface metric = shape.prepared().metric(context);
  return at_input(metric.surface(), gaussian_curvature(metric, options), kNoValue);
}

std::vector<int> descending_order(std::span<const double> saliency) {
  std::vector<int> order;
  for (std::size_t v = 0; v < saliency.size(); ++v)
    if (!std::isnan(saliency[v])) order.push_back(static_cast<int>(v));
  std::ranges::stable_sort(order, std::greater(), [&](int v) { return saliency[v]; });
  return order;
}

}  // namespace isomatch
