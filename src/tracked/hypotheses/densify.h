// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "tracked/hypotheses/search.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// Extends a hypothesis to the first `count` nodes of the source: to each the target node that
/// agrees best with the landmarks. Returns target nodes. O(count * landmarks * nodes).
std::vector<int> densify(const Proxy& source, const Proxy& target, const Hypothesis& hypothesis,
                         int count);

}  // namespace isomatch::tracked
