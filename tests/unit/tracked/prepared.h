// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/shape.h"
#include "tracked/proxy.h"

namespace isomatch::test {

/// A shape as the tracked method prepares it.
struct Prepared {
  explicit Prepared(const Mesh& mesh, const tracked::ProxyOptions& options = {},
                    const Context& context = {})
      : shape(prepare_shape(mesh, {}, context)),
        surface(tracked::unit_surface(shape)),
        proxy(tracked::make_proxy(surface, options, context)) {}

  Shape shape;
  tracked::UnitSurface surface;
  tracked::Proxy proxy;
};

}  // namespace isomatch::test
