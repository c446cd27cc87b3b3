// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <limits>
#include <utility>

#include "geodesics/bucket_queue.h"
#include "isomatch/geodesics.h"

namespace isomatch {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float bucket_width(const GeodesicGraph& graph) {
  const float width = graph.mean_edge_length() / 4;
  return width > 0 ? width : 1;
}

}  // namespace

struct GeodesicSearch::Queue : BucketQueue {
  using BucketQueue::BucketQueue;
};

GeodesicSearch::GeodesicSearch(const GeodesicGraph& graph)
    : graph_(&graph),
      queue_(std::make_unique<Queue>(bucket_width(graph))),
      distances_(graph.num_vertices(), kInfinity) {}

GeodesicSearch::~GeodesicSearch() = default;
GeodesicSearch::GeodesicSearch(GeodesicSearch&&) noexcept = default;
GeodesicSearch& GeodesicSearch::operator=(GeodesicSearch&&) noexcept = default;

template <class Lower>
void GeodesicSearch::propagate(std::span<const float> distances, const Lower& lower) {
  for (BucketQueue::Entry entry; queue_->pop(entry);) {
    if (entry.key > distances[entry.vertex]) continue;
    for (const GeodesicGraph::Arc& arc : graph_->arcs(entry.vertex)) {
      const float distance = entry.key + arc.length;
      if (lower(arc.head, distance)) queue_->push(distance, arc.head);
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
  propagate(distances, [&](int vertex, float distance) {
    if (distance >= distances[vertex]) return false;
    distances[vertex] = distance;
    return true;
  });
}

std::span<const GeodesicSearch::Reached> GeodesicSearch::ball(int source, float radius) {
  reached_.clear();
  if (!(radius >= 0)) return reached_;
  distances_[source] = 0;
  reached_.push_back({source, 0});
  queue_->push(0, source);
  propagate(distances_, [&](int vertex, float distance) {
    if (distance > radius || distance >= distances_[vertex]) return false;
    if (distances_[vertex] == kInfinity) reached_.push_back({vertex, 0});
    distances_[vertex] = distance;
    return true;
  });
  for (Reached& r : reached_) r.distance = std::exchange(distances_[r.vertex], kInfinity);
  std::ranges::sort(reached_, [](const Reached& a, const Reached& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.vertex < b.vertex;
  });
  return reached_;
}

float GeodesicSearch::distance(int from, int to) {
  reached_.clear();
  distances_[from] = 0;
  reached_.push_back({from, 0});
  queue_->push(0, from);
  propagate(distances_, [&](int vertex, float distance) {
    // Nothing beyond `to` can shorten the way to it.
    if (distance >= distances_[vertex] || distance >= distances_[to]) return false;
    if (distances_[vertex] == kInfinity) reached_.push_back({vertex, 0});
    distances_[vertex] = distance;
    return true;
  });
  const float result = distances_[to];
  for (const Reached& r : reached_) distances_[r.vertex] = kInfinity;
  return result;
}

SourcePartition GeodesicSearch::nearest_source(std::span<const int> sources) {
  SourcePartition result;
  result.distances.assign(graph_->num_vertices(), kInfinity);
  result.nearest.assign(graph_->num_vertices(), kNoSource);
  const auto lower = [&](int vertex, float distance, int source) {
    float& old_distance = result.distances[vertex];
    int& old_source = result.nearest[vertex];
    if (distance > old_distance || (distance == old_distance && source >= old_source)) return false;
    old_distance = distance;
    old_source = source;
    return true;
  };
  for (int i = 0; i < static_cast<int>(sources.size()); ++i)
    if (result.nearest[sources[i]] == kNoSource && lower(sources[i], 0, i))
      queue_->push(0, sources[i]);
  for (BucketQueue::Entry entry; queue_->pop(entry);) {
    if (entry.key > result.distances[entry.vertex]) continue;
    const int source = result.nearest[entry.vertex];
    for (const GeodesicGraph::Arc& arc : graph_->arcs(entry.vertex)) {
      const float distance = entry.key + arc.length;
      if (lower(arc.head, distance, source)) queue_->push(distance, arc.head);
    }
  }
  return result;
}

}  // namespace isomatch
