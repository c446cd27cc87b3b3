// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "tracked/proxy.h"

namespace isomatch::tracked {

struct DensifyOptions {
  /// Landmarks at distance g weigh 1 / (g + offset)^2.
  float offset = 0.1F;
};

/// For every node of the source the target vertex that keeps the distances to the landmarks best,
/// near ones before far ones. `source_landmarks` and `target_landmarks` are nodes, in pairs.
std::vector<int> densify(const Proxy& source, const std::vector<int>& source_landmarks,
                         const Proxy& target, const std::vector<int>& target_landmarks,
                         const DensifyOptions& options, const Context& context);

}  // namespace isomatch::tracked
