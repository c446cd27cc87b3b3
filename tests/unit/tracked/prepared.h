// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "shape/prepared_shape.h"
#include "tracked/shape/proxy.h"

namespace isomatch::test {

/// A shape as the tracked method prepares it, with all vertices in the detail; `open` if something
/// may be missing beyond its boundary.
struct Prepared {
  explicit Prepared(const Mesh& mesh, const tracked::ProxyOptions& options = {},
                    const Context& context = {}, bool open = false)
      : shape(mesh, {}),
        surface(*shape.surface()),
        detail(tracked::make_detail(shape, surface, {.detail_vertices = surface.num_vertices()},
                                    context)),
        proxy(tracked::make_proxy(detail, surface.oriented, open, options, context)) {}

  PreparedShape shape;
  const Surface& surface;
  tracked::Detail detail;
  tracked::Proxy proxy;
};

}  // namespace isomatch::test
