// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geodesics/bucket_queue.h"
#include "isomatch/geodesics/geodesics.h"

namespace isomatch {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float bucket_width(const GeodesicGraph& graph) {
  const float width = graph.mean_edge_length() / 4;
  return width > 0 ? width : 1;
}

/// Fetches the arcs of a vertex that will be visited soon.
void prefetch(std::span<const GeodesicGraph::Arc> arcs) {
  constexpr std::size_t kArcsPerCacheLine = 64 / sizeof(GeodesicGraph::Arc);
  for (std::size_t i = 0; i < arcs.size(); i += kArcsPerCacheLine) __builtin_prefetch(&arcs[i]);
}

}  // namespace

struct GeodesicSearch::Queue : BucketQueue {
  using BucketQueue::BucketQueue;
};

GeodesicSearch::GeodesicSearch(const GeodesicGraph& graph)
    : graph_(&graph),
      queue_(std::make_unique<Queue>(bucket_width(graph))),
      distances_(graph.num_vertices(), kInfinity),
      improved_(graph.max_degree()) {}

GeodesicSearch::~GeodesicSearch() = default;
GeodesicSearch::GeodesicSearch(GeodesicSearch&&) noexcept = default;
GeodesicSearch& GeodesicSearch::operator=(GeodesicSearch&&) noexcept = default;

/// Dijkstra's algorithm from what was pushed until the queue is empty. `improves(tail, head,
/// distance)` tells whether the way over `tail` is a better one to `head`, `accept` with the same
/// arguments records it. Entries at `limit` or beyond are dropped; it may fall during the search.
template <class Improves, class Accept>
void GeodesicSearch::propagate(std::span<const float> distances, const float& limit,
                               const Improves& improves, const Accept& accept) {
  for (BucketQueue::Entry entry; queue_->pop(entry);) {
    if (const auto* next = queue_->peek()) prefetch(graph_->arcs(next->vertex));
    if (entry.key > distances[entry.vertex] || entry.key >= limit) continue;
    // Arcs that improve nothing are many and hard to predict, so there is no branch on each.
    Reached* const improved = improved_.data();
    std::size_t count = 0;
    for (const GeodesicGraph::Arc& arc : graph_->arcs(entry.vertex)) {
      const float distance = entry.key + arc.length;
      improved[count] = {arc.head, distance};
      count += improves(entry.vertex, arc.head, distance);
    }
    for (std::size_t i = 0; i < count; ++i) {
      accept(entry.vertex, improved[i].vertex, improved[i].distance);
      queue_->push(improved[i].distance, improved[i].vertex);
    }
  }
}

void GeodesicSearch::field(int source, std::span<float> distances) {
  std::ranges::fill(distances, kInfinity);
  update_field(source, distances);
}

void GeodesicSearch::update_field(int source, std::span<float> distances) {
  if (!(distances[source] > 0)) return;
  distances[source] = 0;
  queue_->push(0, source);
  propagate(
      distances, kInfinity,
      [&](int, int head, float distance) { return distance < distances[head]; },
      [&](int, int head, float distance) { distances[head] = distance; });
}

/// Distances of all vertices closer than `limit` into `distances_`, those vertices into `reached_`.
void GeodesicSearch::collect(int source, const float& limit) {
  reached_.assign(1, {source, 0});
  distances_[source] = 0;
  queue_->push(0, source);
  propagate(
      distances_, limit,
      [&](int, int head, float distance) {
        return (distance < limit) & (distance < distances_[head]);
      },
      [&](int, int head, float distance) {
        if (distances_[head] == kInfinity) reached_.push_back({head, 0});
        distances_[head] = distance;
      });
}

std::span<const GeodesicSearch::Reached> GeodesicSearch::ball(int source, float radius) {
  reached_.clear();
  if (!(radius >= 0)) return reached_;
  collect(source, std::nextafter(radius, kInfinity));
  for (Reached& r : reached_) r.distance = std::exchange(distances_[r.vertex], kInfinity);
  std::ranges::sort(reached_, [](const Reached& a, const Reached& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.vertex < b.vertex;
  });
  return reached_;
}

float GeodesicSearch::distance(int from, int to) {
  // Nothing beyond `to` can shorten the way to it.
  collect(from, distances_[to]);
  const float result = distances_[to];
  for (const Reached& r : reached_) distances_[r.vertex] = kInfinity;
  return result;
}

SourcePartition GeodesicSearch::nearest_source(std::span<const int> sources) {
  SourcePartition result;
  result.distances.assign(graph_->num_vertices(), kInfinity);
  result.nearest.assign(graph_->num_vertices(), kNoSource);
  for (int i = 0; i < static_cast<int>(sources.size()); ++i) {
    if (result.nearest[sources[i]] != kNoSource) continue;
    result.nearest[sources[i]] = i;
    result.distances[sources[i]] = 0;
    queue_->push(0, sources[i]);
  }
  propagate(
      result.distances, kInfinity,
      [&](int tail, int head, float distance) {
        return distance < result.distances[head] ||
               (distance == result.distances[head] && result.nearest[tail] < result.nearest[head]);
      },
      [&](int tail, int head, float distance) {
        result.distances[head] = distance;
        result.nearest[head] = result.nearest[tail];
      });
  return result;
}

}  // namespace isomatch
