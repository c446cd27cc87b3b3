// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracker.h"

#include <algorithm>
#include <cmath>

#include "tracked/densify.h"

namespace isomatch::tracked {
namespace {

spectral::Samples samples_at(const Proxy& proxy, const spectral::Eigenbasis& basis,
                             const elastic::PointCloud& cloud) {
  spectral::Samples samples;
  const auto n = static_cast<Eigen::Index>(cloud.areas.size());
  samples.functions.resize(n, basis.functions.cols());
  samples.areas.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    samples.functions.row(i) = basis.functions.row(proxy.nodes[i]);
    samples.areas[i] = static_cast<float>(cloud.areas[i]);
  }
  return samples;
}

std::vector<Point> node_positions(const Proxy& proxy, const std::vector<int>& nodes) {
  std::vector<Point> positions;
  for (int node : nodes) positions.push_back(proxy.node_position(node));
  return positions;
}

elastic::Projection projection_onto(const Proxy& proxy, const TrackerOptions& options) {
  return {proxy.mesh, proxy.faces, proxy.normals, proxy.features, options.projection};
}

/// Energy of a coarse, stiff registration that starts at `anchors`.
double judged_energy(const Model& source, const elastic::Projection& surface,
                     std::span<const Point> anchors, const TrackerOptions& options) {
  elastic::Deformation deformation(source.coarse.cloud.positions, source.coarse.neighbours);
  return register_onto(source.coarse.cloud, deformation, surface, anchors, options.judging).energy;
}

}  // namespace

std::pair<Model, Model> make_models(const Shape& source, const Shape& target,
                                    const TrackerOptions& options, const Context& context) {
  std::pair<Model, Model> models{{source, unit_surface(source), {}, {}, {}, {}, {}},
                                 {target, unit_surface(target), {}, {}, {}, {}, {}}};
  Model* const both[] = {&models.first, &models.second};
  for (Model* model : both) {
    model->proxy = make_proxy(model->shape, model->surface, options.proxy, context);
    model->coarse = node_graph(model->proxy, options.coarse_nodes);
    model->fine = node_graph(model->proxy, options.proxy.nodes);
  }
#pragma omp parallel for num_threads(context.threads)
  for (int k = 0; k < 2; ++k)
    both[k]->basis = spectral::eigenbasis(both[k]->proxy.mesh, options.last_basis);
  for (Model* model : both)
    model->samples = samples_at(model->proxy, model->basis, model->fine.cloud);
  return models;
}

std::vector<Judged> judge(const Model& source, const Model& target,
                          std::vector<Hypothesis> hypotheses, const TrackerOptions& options,
                          const Context& context) {
  const elastic::Projection surface = projection_onto(target.proxy, options);
  std::vector<Judged> judged(hypotheses.size());
#pragma omp parallel for schedule(dynamic) num_threads(context.threads)
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    const auto anchors =
        node_positions(target.proxy, densify(source.proxy, target.proxy, hypotheses[k],
                                             static_cast<int>(source.coarse.cloud.areas.size())));
    const double energy = judged_energy(source, surface, anchors, options);
    judged[k] = {std::move(hypotheses[k]), energy};
  }
  std::ranges::stable_sort(judged, {}, &Judged::energy);
  return judged;
}

/// What one registration hands on to the next: the target vertex nearest to each foot.
std::vector<int> foot_vertices(const Mesh& mesh, const std::vector<elastic::Foot>& feet) {
  std::vector<int> vertices;
  for (const elastic::Foot& foot : feet) {
    const auto corner = std::ranges::max_element(foot.weights) - foot.weights.begin();
    vertices.push_back(mesh.faces[foot.face][corner]);
  }
  return vertices;
}

double between(double first, double last, double progress) {
  return first * std::pow(last / first, progress);
}

Track follow(const Model& source, const Model& target, const Hypothesis& hypothesis,
             const TrackerOptions& options, const Context& context) {
  const elastic::Projection surface = projection_onto(target.proxy, options);
  const elastic::PointCloud& cloud = source.fine.cloud;
  const spectral::SpectralTarget spectral{target.proxy.mesh, target.basis};
  Track track{{cloud.positions, source.fine.neighbours}, {}, 0};
  std::vector<Point> anchors = node_positions(
      target.proxy,
      densify(source.proxy, target.proxy, hypothesis, static_cast<int>(cloud.areas.size())));
  track.registration =
      register_onto(cloud, track.deformation, surface, anchors, options.first_registration);
  for (int round = 0; round < options.rounds; ++round) {
    const double progress = static_cast<double>(round) / std::max(1, options.rounds - 1);
    const int size =
        static_cast<int>(std::lround(between(options.first_basis, options.last_basis, progress)));
    const std::vector<int> vertices =
        refine(source.samples, spectral, foot_vertices(target.proxy.mesh, track.registration.feet),
               size, context);
    for (std::size_t i = 0; i < anchors.size(); ++i)
      anchors[i] = target.proxy.mesh.vertices[vertices[i]];
    elastic::RegistrationOptions step = options.alternation;
    step.first_length = step.last_length = between(step.first_length, step.last_length, progress);
    track.registration = register_onto(cloud, track.deformation, surface, anchors, step);
  }
  const auto& positions = track.deformation.positions();
  track.energy = judged_energy(
      source, surface, std::span(positions).first(source.coarse.cloud.areas.size()), options);
  return track;
}

std::vector<Finalist> run_finals(const Model& source, const Model& target,
                                 const std::vector<Judged>& judged, const TrackerOptions& options,
                                 const Context& context) {
  const auto distance = [&](const Track& a, const Track& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.registration.feet.size(); ++i)
      sum += source.fine.cloud.areas[i] *
             (a.registration.feet[i].position - b.registration.feet[i].position).norm();
    return sum;
  };
  std::vector<Finalist> finalists;
  for (const Judged& j : judged) {
    if (static_cast<int>(finalists.size()) == options.finalists) break;
    finalists.push_back({j.hypothesis, follow(source, target, j.hypothesis, options, context)});
  }
  std::ranges::stable_sort(finalists, {}, [](const Finalist& f) { return f.track.energy; });
  std::vector<Finalist> different;
  for (Finalist& finalist : finalists) {
    const bool known = std::ranges::any_of(different, [&](const Finalist& other) {
      return distance(finalist.track, other.track) < options.hypotheses.same_distance;
    });
    if (!known) different.push_back(std::move(finalist));
  }
  return different;
}

}  // namespace isomatch::tracked
