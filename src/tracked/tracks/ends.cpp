// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/ends.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tracked/hypotheses/seeds.h"

namespace isomatch::tracked {
namespace {

/// The end of a limb, with what is around the joint behind it.
struct End {
  /// Nodes of the track's level, and how much of a turn of the end each takes part in.
  std::vector<int> nodes;
  std::vector<double> share;
  /// The axis of the end where the track has it.
  Point centre{0, 0, 0}, axis{0, 0, 0};
};

/// An end as registered alone, and where its nodes are then.
struct Fit {
  double cost = 0;
  std::vector<int> vertices;
};

/// How far from the tip the limb is narrowest.
double reach_of_end(const Track& track, int tip, const TurningOptions& options) {
  const Proxy& proxy = track.judged.source->proxy;
  const auto ring_at = [&](double distance) {
    return static_cast<std::size_t>(distance / options.ring);
  };
  const std::size_t first = std::max<std::size_t>(1, ring_at(options.shortest)),
                    last = std::max(first, ring_at(options.longest));
  std::vector<double> areas(last + 2);
  for (int i = 0; i < track.source->size(); ++i) {
    const std::size_t ring = ring_at(proxy.distances(tip, proxy.nodes[i]));
    if (ring < areas.size()) areas[ring] += track.cloud.areas[i];
  }
  std::size_t narrowest = first;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t ring = first; ring <= last; ++ring) {
    const double section = areas[ring - 1] + 2 * areas[ring] + areas[ring + 1];
    if (section >= least) continue;
    least = section;
    narrowest = ring;
  }
  return (static_cast<double>(narrowest) + 0.5) * options.ring;
}

/// Empty if there are too few nodes.
End end_at(const Track& track, int tip, const TurningOptions& options) {
  const Proxy& proxy = track.judged.source->proxy;
  const double reach = reach_of_end(track, tip, options);
  End end;
  Point joint(0, 0, 0);
  double end_area = 0, joint_area = 0;
  for (int i = 0; i < track.source->size(); ++i) {
    const double beyond = proxy.distances(tip, proxy.nodes[i]) - reach;
    if (beyond > options.twisted + options.held) continue;
    end.nodes.push_back(i);
    end.share.push_back(std::clamp(1 - beyond / options.twisted, 0.0, 1.0));
    const double area = track.cloud.areas[i];
    const Point weighed = area * track.deformation.positions()[i];
    if (beyond < 0) {
      end.centre += weighed;
      end_area += area;
    }
    if (std::abs(beyond) < options.held) {
      joint += weighed;
      joint_area += area;
    }
  }
  if (end_area == 0 || joint_area == 0) return {};
  end.centre /= end_area;
  end.axis = (end.centre - joint / joint_area).stableNormalized();
  return end;
}

/// Neighbours among some of the nodes, by their rows.
IndexLists neighbours_among(const std::vector<int>& nodes, const IndexLists& neighbours) {
  std::vector<int> offsets{0}, values;
  for (const int node : nodes) {
    for (const int other : neighbours[node]) {
      const auto at = std::ranges::lower_bound(nodes, other);
      if (at != nodes.end() && *at == other) values.push_back(static_cast<int>(at - nodes.begin()));
    }
    offsets.push_back(static_cast<int>(values.size()));
  }
  return {std::move(offsets), std::move(values)};
}

elastic::PointCloud cloud_of(const elastic::PointCloud& cloud, const std::vector<int>& nodes) {
  elastic::PointCloud part;
  for (const int node : nodes) {
    part.positions.push_back(cloud.positions[node]);
    part.normals.push_back(cloud.normals[node]);
    part.areas.push_back(cloud.areas[node]);
    part.features.push_back(cloud.features[node]);
  }
  return part;
}

/// Registers an end alone, beginning where the track has it but turned by `angle`; what takes no
/// part in the turn is held.
Fit fit(const Track& track, const End& end, double angle, const Proxy& target,
        const elastic::Projection& surface, const TurningOptions& options) {
  const Context alone{.threads = 1, .progress = {}, .stop = {}};  // It is small.
  const elastic::PointCloud cloud = cloud_of(track.cloud, end.nodes);
  std::vector<Point> anchors;
  std::vector<elastic::Pin> pins;
  for (std::size_t k = 0; k < end.nodes.size(); ++k) {
    const int node = end.nodes[k];
    Point position = track.deformation.positions()[node];
    if (end.share[k] == 0) pins.push_back({static_cast<int>(k), position});
    if (end.share[k] > 0 && angle != 0) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(end.share[k] * angle, end.axis));
      const Point normal = turn * (track.deformation.rotations()[node] * cloud.normals[k]);
      position =
          surface(end.centre + turn * (position - end.centre), normal, cloud.features[k]).position;
    }
    anchors.push_back(position);
  }
  elastic::Deformation deformation(cloud.positions,
                                   neighbours_among(end.nodes, track.source->graph.neighbours));
  const elastic::Registration registration =
      register_onto(cloud, deformation, surface, anchors, options.registration, pins, alone);
  return {registration.energy * registration.distance,
          nearest_vertices(target.mesh, registration.feet)};
}

/// How far the end is from where the track has it, against what half a turn would move it by:
/// little where a thin end has slid back.
double part_of_half_turn(const Track& track, const End& end, const std::vector<int>& vertices,
                         const Proxy& target) {
  double moved = 0, turned = 0;
  for (std::size_t k = 0; k < end.nodes.size(); ++k) {
    if (end.share[k] < 1) continue;
    const Point& position = track.deformation.positions()[end.nodes[k]];
    moved += (target.mesh.vertices[vertices[k]] - position).norm();
    turned += 2 * (position - end.centre).cross(end.axis).norm();
  }
  return turned > 0 ? moved / turned : 0;
}

}  // namespace

std::vector<int> with_an_end_turned(const Track& track, const Proxy& target,
                                    const elastic::Projection& surface, const Options& options) {
  const TurningOptions& turning = options.turning;
  double least = turning.tolerable;
  std::vector<int> vertices;
  for (const int tip : extremities(track.judged.source->proxy, options.hypotheses.seeds)) {
    const End end = end_at(track, tip, turning);
    if (end.nodes.empty()) continue;
    const double before = fit(track, end, 0, target, surface, turning).cost;
    // Both ways round: the limb may be twisted already.
    for (const double angle : {std::numbers::pi, -std::numbers::pi}) {
      const Fit turned = fit(track, end, angle, target, surface, turning);
      if (turned.cost >= least * before ||
          part_of_half_turn(track, end, turned.vertices, target) < turning.least_turned)
        continue;
      least = turned.cost / before;
      vertices = track.vertices;
      for (std::size_t k = 0; k < end.nodes.size(); ++k)
        vertices[end.nodes[k]] = turned.vertices[k];
    }
  }
  return vertices;
}

}  // namespace isomatch::tracked
