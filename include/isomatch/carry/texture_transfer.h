// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/maps/surface_map.h"
#include "isomatch/mesh/texture.h"

namespace isomatch {

struct TextureTransferOptions {
  /// Cut target faces along the seams of the source's texture. It adds vertices at the end and
  /// leaves the surface as it is. Otherwise a face that a seam crosses is covered by the side on
  /// which its centre lies, stretched up to the corners beyond.
  bool cut_seams = true;
};

/// Covers the target with the texture of the source; the images are used as they are.
///
/// A target face takes the part of the texture, and the material, that its centre falls on. The
/// coordinates of its corners are those of the same part there, found by walking from the centre
/// without crossing a seam (an edge at which coordinates or materials of its faces differ): a
/// corner beyond a seam takes those of the nearest point before it, so that nothing shows which
/// lies outside of the texture's parts. Target faces with an unmatched corner, and those that lie
/// where the source has no texture, have no coordinates and no material.
///
/// `target`'s vertices keep their numbers; faces too, unless seams are cut. Coordinates that
/// several faces share at a vertex are one. Deterministic; O(N) as a rule. Throws `InvalidInput` if
/// the texture or the map does not fit.
TexturedMesh transfer_texture(const Mesh& source, const Texture& texture, const Mesh& target,
                              const SurfaceMap& target_to_source,
                              const TextureTransferOptions& options = {});

}  // namespace isomatch
