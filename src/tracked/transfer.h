// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "elastic/deformation.h"
#include "elastic/nearest_point.h"
#include "isomatch/context.h"
#include "tracked/model.h"

namespace isomatch::tracked {

/// Carries a deformation of the first nodes of a model, and the places where they went, over to all
/// vertices of its surface: their positions and normals then, their relief at rest, and where they
/// went. O(N log N).
elastic::Cloud transfer(const Model& model, const elastic::Deformation& deformation,
                        const std::vector<elastic::Features>& node_features,
                        const Context& context);

}  // namespace isomatch::tracked
