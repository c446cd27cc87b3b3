// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "isomatch/carry/transfer.h"
#include "isomatch/error.h"
#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/topology.h"

namespace isomatch {
namespace {

void check(const Mesh& source, const SurfaceMap& target_to_source, std::size_t values) {
  check_map(target_to_source, static_cast<int>(target_to_source.size()), source.num_faces());
  if (values != source.vertices.size())
    throw InvalidInput(
        fmt::format("there are {} values for {} source vertices", values, source.num_vertices()));
}

/// What a face's corners say, each with its weight; a face has few corners, so the lists are short.
struct Votes {
  std::vector<Influence> sums;

  void add(int candidate, double weight) {
    for (Influence& sum : sums) {
      if (sum.bone != candidate) continue;
      sum.weight += weight;
      return;
    }
    sums.push_back({candidate, weight});
  }

  /// Most votes first, of equal ones the lower candidate.
  void sort() {
    std::ranges::sort(sums, [](const Influence& a, const Influence& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.bone < b.bone;
    });
  }
};

int elected_label(const Face& face, const SurfacePoint& point, std::span<const int> labels) {
  Votes votes;
  for (int k = 0; k < 3; ++k) {
    const int label = labels[face[k]];
    if (label != kNoLabel && point.weights[k] > 0) votes.add(label, point.weights[k]);
  }
  votes.sort();
  return votes.sums.empty() ? kNoLabel : votes.sums.front().bone;
}

void check_influences(const std::vector<Influence>& influences, std::size_t vertex) {
  for (std::size_t i = 0; i < influences.size(); ++i) {
    const auto& [bone, weight] = influences[i];
    if (!std::isfinite(weight) || weight < 0)
      throw InvalidInput(fmt::format("vertex {} has the skinning weight {}", vertex, weight));
    for (std::size_t j = 0; j < i; ++j) {
      if (influences[j].bone == bone)
        throw InvalidInput(fmt::format("vertex {} has bone {} twice", vertex, bone));
    }
  }
}

std::vector<Influence> blended(const Face& face, const SurfacePoint& point,
                               const SkinWeights& weights, std::size_t most) {
  Votes votes;
  for (int k = 0; k < 3; ++k)
    for (const auto& [bone, weight] : weights[face[k]]) {
      if (point.weights[k] * weight > 0) votes.add(bone, point.weights[k] * weight);
    }
  votes.sort();
  std::vector<Influence>& kept = votes.sums;
  if (kept.size() > most) kept.resize(most);
  double sum = 0;
  for (const Influence& influence : kept) sum += influence.weight;
  for (Influence& influence : kept) influence.weight /= sum;
  std::ranges::sort(kept, {}, &Influence::bone);
  return kept;
}

}  // namespace

Eigen::MatrixXd transfer_values(const Mesh& source, const SurfaceMap& target_to_source,
                                const Eigen::MatrixXd& values) {
  check(source, target_to_source, values.rows());
  Eigen::MatrixXd result = Eigen::MatrixXd::Constant(std::ssize(target_to_source), values.cols(),
                                                     std::numeric_limits<double>::quiet_NaN());
  for (std::size_t t = 0; t < target_to_source.size(); ++t) {
    const SurfacePoint& point = target_to_source[t];
    if (point.face == kNoFace) continue;
    const Face& face = source.faces[point.face];
    result.row(t) = Eigen::RowVectorXd::Zero(values.cols());
    for (int k = 0; k < 3; ++k) {
      // What a corner of no weight holds, perhaps NaN, plays no part.
      if (point.weights[k] != 0) result.row(t) += point.weights[k] * values.row(face[k]);
    }
  }
  return result;
}

std::vector<int> transfer_labels(const Mesh& source, const SurfaceMap& target_to_source,
                                 std::span<const int> labels) {
  check(source, target_to_source, labels.size());
  std::vector<int> result(target_to_source.size(), kNoLabel);
  for (std::size_t t = 0; t < result.size(); ++t) {
    const SurfacePoint& point = target_to_source[t];
    if (point.face != kNoFace) result[t] = elected_label(source.faces[point.face], point, labels);
  }
  return result;
}

SkinWeights transfer_skin(const Mesh& source, const SurfaceMap& target_to_source,
                          const SkinWeights& weights) {
  check(source, target_to_source, weights.size());
  std::size_t most = 0;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    check_influences(weights[v], v);
    most = std::max(most, weights[v].size());
  }
  SkinWeights result(target_to_source.size());
  for (std::size_t t = 0; t < result.size(); ++t) {
    const SurfacePoint& point = target_to_source[t];
    if (point.face != kNoFace) result[t] = blended(source.faces[point.face], point, weights, most);
  }
  return result;
}

}  // namespace isomatch
