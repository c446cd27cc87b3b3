// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/ground_truth.h"

#include <array>

#include "geometry/kd_tree.h"
#include "parallel.h"

namespace isomatch::synth {

SurfaceLookup::SurfaceLookup(const Body& body, const std::vector<Point>& rest,
                             const Context& context)
    : body_(&body), rest_(&rest), context_(&context), tree_(std::make_unique<KdTree<3>>(rest)) {}

SurfaceLookup::~SurfaceLookup() = default;

int SurfaceLookup::nearest(const Point& query) const {
  std::array<int, 8> candidates{};
  const std::size_t count = tree_->nearest(query, candidates);
  const Vector normal = body_->normal(query);
  for (std::size_t i = 0; i < count; ++i) {
    if (body_->normal((*rest_)[candidates[i]]).dot(normal) > 0.2) return candidates[i];
  }
  return candidates[0];
}

std::vector<int> SurfaceLookup::nearest(const std::vector<Point>& queries) const {
  std::vector<int> result(queries.size());
  parallel_for(std::ssize(queries), *context_,
               [&](std::ptrdiff_t i) { result[i] = nearest(queries[i]); });
  return result;
}

}  // namespace isomatch::synth
