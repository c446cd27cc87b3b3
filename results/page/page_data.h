// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "isomatch/context.h"
#include "results/drawing/pair_view.h"
#include "results/page/filled_page.h"
#include "results/page/measures.h"
#include "results/page/shown_match.h"

namespace isomatch::results {

struct PageOptions {
  TruthFiles truth;
  ViewOptions view;
};

/// Measures the maps of `match` and packs all that the page needs. Vertices are those shown (see
/// `DisplayMesh`). Arrays, n and m the vertices shown of the source and the target:
/// - source/numbers, source/position (3n: all x, all y, all z), source/corner0, corner1, corner2;
///   target likewise. Corners 1 and 2 are zigzag differences from corner 0;
/// - for map K, 0 the best: maps/K/image (3n), maps/K/partner (n: target vertex + 1, 0 where
///   unmatched), maps/K/back (m: source vertex + 1, 0), maps/K/registered (3n, if the method
///   registers), maps/K/d_iso (n), maps/K/error (n, if there is a truth), maps/K/source_confidence
///   (n) and maps/K/target_confidence (m), if the method tells;
/// - for level K of the paper's method: levels/K/source, levels/K/target, levels/K/d_iso.
/// Coordinates and distances are 16-bit steps; the manifest has the steps' `low` and `size`.
/// Distances keep 65535 for what was not measured. Confidences are steps of 1 / 254; 255 is
/// unmatched.
PageData page_data(ShownMatch match, const PageOptions& options, const Context& context);

}  // namespace isomatch::results
