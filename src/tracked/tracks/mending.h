// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "tracked/options.h"
#include "tracked/shape/proxy.h"

namespace isomatch::tracked {

/// A map of the first nodes of a proxy to nodes of another one, where those that are out of place
/// are moved. The place of each is where it agrees best with all others, of which those that agree
/// badly themselves count less; it is out of place if another one, not close by, agrees clearly
/// better. So parts that were exchanged with their twins, an elephant's tusks, find back.
/// `target_nodes` are among the measured ones; O(nodes^2 * places), places as many as `places`.
std::vector<int> mended(const Proxy& source, const Proxy& target, std::span<const double> areas,
                        std::vector<int> target_nodes, int places, const MendingOptions& options);

}  // namespace isomatch::tracked
