// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

std::vector<int> node_vertices(const Proxy& proxy, std::vector<int> nodes) {
  for (int& node : nodes) node = proxy.nodes[node];
  return nodes;
}

std::vector<Point> positions_of(const Mesh& mesh, const std::vector<int>& vertices) {
  std::vector<Point> positions;
  for (int v : vertices) positions.push_back(mesh.vertices[v]);
  return positions;
}

int nearest_node(const Model& model, int surface_vertex) {
  const Point& p = model.surface.mesh.vertices[surface_vertex];
  const auto& nodes = model.fine.cloud.positions;
  const auto nearest = std::ranges::min_element(
      nodes, {}, [&](const Point& node) { return (node - p).squaredNorm(); });
  return static_cast<int>(nearest - nodes.begin());
}

/// Of landmarks that share a node the first remains.
void drop_repeated_nodes(Correspondence& landmarks) {
  Correspondence kept;
  for (const Match& match : landmarks) {
    const bool repeated = std::ranges::any_of(kept, [&](const Match& other) {
      return other.source == match.source || other.target == match.target;
    });
    if (!repeated) kept.push_back(match);
  }
  landmarks = std::move(kept);
}

elastic::Projection projection_onto(const Proxy& proxy, const elastic::ProjectionWeights& weights) {
  return {proxy.mesh, proxy.faces, proxy.normals, proxy.features, weights};
}

/// Where the nodes nearest to landmarks belong, up to their distance from these.
std::vector<elastic::Pin> landmark_pins(const Model& source, const Model& target,
                                        const Correspondence& landmarks) {
  std::vector<elastic::Pin> pins;
  for (const Match& match : landmarks)
    pins.push_back(
        {nearest_node(source, match.source), target.surface.mesh.vertices[match.target]});
  return pins;
}

/// Notes on which target vertex each point is now.
void set_places(elastic::PointCloud& cloud, const Proxy& target, std::span<const int> vertices) {
  for (std::size_t i = 0; i < cloud.features.size(); ++i)
    cloud.features[i].place = target.features[vertices[i]].place;
}

/// Energy of a coarse, stiff registration that starts at `anchors`, which lie at `vertices`.
double judged_energy(const Model& source, const Model& target, const elastic::Projection& surface,
                     std::span<const Point> anchors, std::span<const int> vertices,
                     const TrackerOptions& options) {
  elastic::PointCloud cloud = source.coarse.cloud;
  set_places(cloud, target.proxy, vertices);
  elastic::Deformation deformation(cloud.positions, source.coarse.neighbours);
  return register_onto(cloud, deformation, surface, anchors, options.judging).energy;
}

/// Places of all vertices, as the proxy's have them.
void set_places(Model& model, const Context& context) {
  std::vector<int> sources;
  for (int k = 0; k < std::min(elastic::kPlaces, model.proxy.num_nodes()); ++k)
    sources.push_back(model.proxy.surface_vertex[model.proxy.nodes[k]]);
  const std::vector<float> fields = geodesic_fields(model.shape.graph, sources, context);
  const std::size_t n = model.surface.features.size();
  for (std::size_t k = 0; k < sources.size(); ++k)
    for (std::size_t v = 0; v < n; ++v)
      model.surface.features[v].place[k] = fields[k * n + v] / model.surface.scale;
}

}  // namespace

Model make_model(const Shape& shape, bool mirrored, const TrackerOptions& options,
                 const Context& context) {
  Model model{shape, unit_surface(shape, mirrored), {}, {}, {}, {}, {}, mirrored};
  model.proxy = make_proxy(model.surface, options.proxy, context);
  set_places(model, context);
  model.coarse = node_graph(model.proxy, options.coarse_nodes);
  model.fine = node_graph(model.proxy, options.proxy.nodes);
  model.basis = spectral::eigenbasis(model.proxy.mesh, options.last_basis);
  model.samples = samples_at(model.proxy, model.basis, model.fine.cloud);
  return model;
}

std::vector<Judged> judged_hypotheses(const Model& source, const Model& target,
                                      const TrackerOptions& options, const Context& context) {
  HypothesisOptions hypothesis_options = options.hypotheses;
  for (const Match& match : options.landmarks)
    hypothesis_options.landmarks.push_back(
        {nearest_node(source, match.source), nearest_node(target, match.target)});
  drop_repeated_nodes(hypothesis_options.landmarks);
  hypothesis_options.growth.fixed = static_cast<int>(hypothesis_options.landmarks.size());
  std::vector<Hypothesis> hypotheses =
      find_hypotheses(source.proxy, target.proxy, hypothesis_options, context);
  const elastic::Projection surface = projection_onto(target.proxy, options.early_projection);
  std::vector<Judged> judged(hypotheses.size());
#pragma omp parallel for schedule(dynamic) num_threads(context.threads)
  for (std::size_t k = 0; k < hypotheses.size(); ++k) {
    const std::vector<int> vertices =
        node_vertices(target.proxy, densify(source.proxy, target.proxy, hypotheses[k],
                                            static_cast<int>(source.coarse.cloud.areas.size())));
    const double energy = judged_energy(
        source, target, surface, positions_of(target.proxy.mesh, vertices), vertices, options);
    judged[k] = {std::move(hypotheses[k]), energy, &source};
  }
  if (options.elastic_judging) sort_by_cost(judged, options);
  return judged;
}

double Judged::cost(const TrackerOptions& options) const {
  return energy * std::pow(hypothesis.distortion, options.distortion_power);
}

double Track::cost(const TrackerOptions& options) const {
  return energy * std::pow(distortion, options.final_distortion_power);
}

void sort_by_cost(std::vector<Judged>& judged, const TrackerOptions& options) {
  std::ranges::stable_sort(judged, {}, [&](const Judged& j) { return j.cost(options); });
}

namespace {

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

/// Mean isometric distortion between the first nodes of the source and their images.
double distortion(const Proxy& source, const Proxy& target, std::span<const int> vertices) {
  const int count = std::min<int>(100, static_cast<int>(vertices.size()));
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    Eigen::Index near = 0;
    target.distances.col(vertices[i]).minCoeff(&near);
    for (int j = 0; j < count; ++j)
      sum += std::abs(source.node_distance(i, j) - target.distances(near, vertices[j]));
  }
  return sum / (count * count);
}

/// Carries a hypothesis to the fine nodes and refines it: spectral steps know distances along the
/// surface, registrations know its shape in space.
Track follow(const Judged& judged, const Model& target, const TrackerOptions& options,
             const Context& context) {
  const Model& source = *judged.source;
  const Hypothesis& hypothesis = judged.hypothesis;
  const elastic::Projection surface = projection_onto(target.proxy, options.early_projection);
  elastic::PointCloud cloud = source.fine.cloud;
  const std::vector<elastic::Pin> pins = landmark_pins(source, target, options.landmarks);
  const Mesh& mesh = target.proxy.mesh;
  Track track{{cloud.positions, source.fine.neighbours}, {}, {}, 0, 0};
  std::vector<int> vertices = node_vertices(
      target.proxy,
      densify(source.proxy, target.proxy, hypothesis, static_cast<int>(cloud.areas.size())));
  const elastic::Projection late_surface = projection_onto(target.proxy, options.late_projection);
  const auto advance = [&](const elastic::Projection& onto,
                           const elastic::RegistrationOptions& step) {
    set_places(cloud, target.proxy, vertices);
    track.registration =
        register_onto(cloud, track.deformation, onto, positions_of(mesh, vertices), step, pins);
    vertices = foot_vertices(mesh, track.registration.feet);
  };
  advance(surface, options.first_registration);
  for (int round = 0; round < options.rounds; ++round) {
    const double progress = static_cast<double>(round) / std::max(1, options.rounds - 1);
    const double size = between(options.first_basis, options.last_basis, progress);
    vertices = refine(source.samples, target.basis, vertices, static_cast<int>(std::lround(size)),
                      context);
    elastic::RegistrationOptions step = options.alternation;
    step.first_length = step.last_length = between(step.first_length, step.last_length, progress);
    advance(late_surface, step);
  }
  set_places(cloud, target.proxy, vertices);
  track.features = cloud.features;
  track.distortion = distortion(source.proxy, target.proxy, vertices);
  const auto coarse = source.coarse.cloud.areas.size();
  track.energy =
      judged_energy(source, target, surface, std::span(track.deformation.positions()).first(coarse),
                    std::span(vertices).first(coarse), options);
  return track;
}

/// Mean distance between the images of the nodes.
double distance(const Track& a, const Track& b, const std::vector<double>& areas) {
  double sum = 0;
  for (std::size_t i = 0; i < areas.size(); ++i)
    sum += areas[i] * (a.registration.feet[i].position - b.registration.feet[i].position).norm();
  return sum;
}

/// Mean distance between the images of a hypothesis's landmarks and those of a track.
double distance(const Track& track, const Hypothesis& hypothesis, const Proxy& target) {
  double sum = 0;
  for (std::size_t i = 0; i < hypothesis.source_nodes.size(); ++i)
    sum += (track.registration.feet[hypothesis.source_nodes[i]].position -
            target.node_position(hypothesis.target_nodes[i]))
               .norm();
  return sum / static_cast<double>(hypothesis.source_nodes.size());
}

/// Energies of all that was judged, but is not the winner's map: raw hypotheses lie about as far
/// from their refinement as twice `same_distance`.
double confidence(const Finals& finals, const std::vector<Judged>& judged, const Model& target,
                  const TrackerOptions& options) {
  const Finalist& winner = finals.finalists.front();
  double rival = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < finals.finalists.size(); ++k)
    rival = std::min(rival, finals.finalists[k].track.cost(options));
  for (const Judged& j : judged) {
    if (j.source != winner.judged.source ||
        distance(winner.track, j.hypothesis, target.proxy) > 2 * options.hypotheses.same_distance)
      rival = std::min(
          rival, j.energy * std::pow(j.hypothesis.distortion, options.final_distortion_power));
  }
  return rival > 0 ? std::clamp(1 - winner.track.cost(options) / rival, 0.0, 1.0) : 0.0;
}

}  // namespace

Finals run_finals(const Model& target, const std::vector<Judged>& judged,
                  const TrackerOptions& options, const Context& context) {
  Finals finals;
  int followed = 0;
  for (const Judged& j : judged) {
    context.check_stop();
    const bool enough = std::cmp_greater_equal(finals.finalists.size(), options.different_maps);
    if (enough && followed >= options.finalists) break;
    ++followed;
    Finalist finalist{j, follow(j, target, options, context)};
    const auto known = std::ranges::find_if(finals.finalists, [&](const Finalist& other) {
      return other.judged.source == j.source &&
             distance(finalist.track, other.track, j.source->fine.cloud.areas) <
                 options.hypotheses.same_distance;
    });
    if (known == finals.finalists.end()) {
      finals.finalists.push_back(std::move(finalist));
    } else if (options.elastic_judging &&
               finalist.track.cost(options) < known->track.cost(options)) {
      *known = std::move(finalist);
    }
  }
  if (options.elastic_judging)
    std::ranges::stable_sort(finals.finalists, {},
                             [&](const Finalist& f) { return f.track.cost(options); });
  finals.confidence = confidence(finals, judged, target, options);
  return finals;
}

}  // namespace isomatch::tracked
