// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <vector>

#include "elastic/features.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::elastic {

/// Finds the point of a set that is closest in position, normal and features.
class NearestPoint {
 public:
  NearestPoint(const std::vector<Point>& positions, const std::vector<Point>& normals,
               const std::vector<Features>& features, const ProjectionWeights& weights);
  ~NearestPoint();

  int operator()(const Point& position, const Point& normal, const Features& features) const;

 private:
  struct Index;

  ProjectionWeights weights_;
  std::unique_ptr<Index> index_;
};

}  // namespace isomatch::elastic
