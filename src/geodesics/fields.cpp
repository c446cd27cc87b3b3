// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <algorithm>
#include <cmath>

#include "isomatch/geodesics.h"

namespace isomatch {

std::vector<float> geodesic_fields(const GeodesicGraph& graph, std::span<const int> sources,
                                   const Context& context) {
  const std::size_t n = graph.num_vertices();
  std::vector<float> fields(sources.size() * n);
#pragma omp parallel num_threads(context.threads)
  {
    GeodesicSearch search(graph);
#pragma omp for schedule(dynamic)
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (!context.stop.stop_requested()) search.field(sources[i], {fields.data() + i * n, n});
    }
  }
  context.check_stop();
  return fields;
}

}  // namespace isomatch
