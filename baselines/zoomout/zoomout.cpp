// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "zoomout/zoomout.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <future>
#include <numeric>

#include "isomatch/error.h"
#include "spectral/eigenbasis.h"
#include "spectral/nearest_rows.h"
#include "zoomout/wave_kernel.h"

namespace isomatch::baselines {
namespace {

/// Eigenfunctions of a surface, and what its vertices stand for.
struct Spectrum {
  Eigen::MatrixXf functions;
  Eigen::VectorXd values;
  Eigen::VectorXd areas;
};

Spectrum spectrum(const MetricSurface& shape, int count) {
  isomatch::spectral::Eigenbasis basis = isomatch::spectral::eigenbasis(shape.mesh(), count);
  if (basis.values.size() < count)
    throw InvalidInput(fmt::format("zoomout needs surfaces of more than {} vertices", count));
  return {std::move(basis.functions), std::move(basis.values),
          Eigen::Map<const Eigen::VectorXd>(shape.vertex_areas().data(), shape.num_vertices())};
}

DescribedBasis described(const MetricSurface& shape, const Spectrum& spectrum,
                         const ZoomOutOptions& options) {
  const Eigen::MatrixXd functions =
      spectrum.functions.leftCols(options.signature_functions).cast<double>();
  const Eigen::MatrixXd signatures = wave_kernel_signatures(
      functions, spectrum.values.head(options.signature_functions), options.energies);
  const auto chosen = Eigen::seqN(
      0, (options.energies + options.energy_step - 1) / options.energy_step, options.energy_step);
  return describe(shape.mesh(), spectrum.areas, functions.leftCols(options.first_size),
                  spectrum.values.head(options.first_size), signatures(Eigen::all, chosen));
}

/// Rows of the eigenfunctions at evenly spread vertices.
Eigen::MatrixXf sampled(const MetricSurface& shape, const Eigen::MatrixXf& functions, int count) {
  std::vector<int> vertices(shape.num_vertices());
  std::iota(vertices.begin(), vertices.end(), 0);
  return functions(farthest_points(shape.graph(), vertices, count), Eigen::all);
}

/// Target point of each source point under a functional map of target to source functions.
std::vector<int> pointwise(const Eigen::MatrixXf& map, const Eigen::MatrixXf& source,
                           const Eigen::MatrixXf& target, const Context& context) {
  return isomatch::spectral::nearest_rows(source.leftCols(map.rows()),
                                          target.leftCols(map.cols()) * map.transpose(), context);
}

/// The functional map of target to source functions that a map of points stands for.
Eigen::MatrixXf functional(const std::vector<int>& points, const Eigen::MatrixXf& source,
                           const Eigen::MatrixXf& target, int size) {
  const Eigen::MatrixXf pulled = target(points, Eigen::seqN(0, size));
  return source.leftCols(size).householderQr().solve(pulled);
}

/// Of the functional maps after the first one.
std::vector<int> sizes(const ZoomOutOptions& options) {
  std::vector<int> all(options.first_rounds, options.first_size);
  for (int size = options.first_size + options.step; size <= options.last_size;
       size += options.step)
    all.push_back(size);
  return all;
}

}  // namespace

void ZoomOutOptions::validate() const {
  if (energies < 2 || energy_step < 1)
    throw InvalidInput("energies must be at least 2, energy_step at least 1");
  if (step < 1 || first_size < 2 || last_size < first_size)
    throw InvalidInput("sizes of functional maps must begin at 2 at least and grow");
  if (signature_functions < first_size || signature_functions > last_size)
    throw InvalidInput("signature_functions must be between first_size and last_size");
  if (first_rounds < 0) throw InvalidInput("first_rounds must not be negative");
  if (samples < last_size) throw InvalidInput("samples must be at least last_size");
}

ZoomOutResult match_zoomout(const MetricSurface& source, const MetricSurface& target,
                            const ZoomOutOptions& options, const Context& context) {
  options.validate();
  ZoomOutResult result;
  const auto [on_source, on_target] = [&] {
    const StageTimer timer(result.times, "eigenfunctions");
    const auto policy = context.threads > 1 ? std::launch::async : std::launch::deferred;
    auto other = std::async(policy, [&] { return spectrum(target, options.last_size); });
    Spectrum one = spectrum(source, options.last_size);
    return std::pair{std::move(one), other.get()};
  }();
  context.check_stop();
  Eigen::MatrixXf map;
  {
    const StageTimer timer(result.times, "functional map");
    map = fit_functional_map(described(target, on_target, options),
                             described(source, on_source, options), options.weights)
              .cast<float>();
  }
  const StageTimer timer(result.times, "upsampling");
  const Eigen::MatrixXf source_samples = sampled(source, on_source.functions, options.samples);
  const Eigen::MatrixXf target_samples = sampled(target, on_target.functions, options.samples);
  for (int size : sizes(options)) {
    const std::vector<int> points = pointwise(map, source_samples, target_samples, context);
    map = functional(points, source_samples, target_samples, size);
    context.check_stop();
  }
  result.source_to_target = pointwise(map, on_source.functions, on_target.functions, context);
  return result;
}

}  // namespace isomatch::baselines
