// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/context.h"
#include "results/folder/result.h"

namespace isomatch::cli {

/// From where to where, and what for, the command line wants something carried.
struct TransferArguments {
  std::string folder, output;
  results::MeshPlaces places;
  bool reverse = false;
  std::size_t alternative = 0;
  /// Files of what is to be carried; exactly one is given.
  std::string values, labels, colors, landmarks, skin, texture;
  std::vector<std::string> poses;
  /// An image for a texture whose file names none.
  std::string image;
  bool keep_faces = false;
  bool same_rest_pose = false;
  bool quiet = false;
};

/// Two meshes and the map between them that carries from the one onto the other: the source of the
/// match onto its target, or in reverse.
struct TransferJob {
  std::string from_path;
  Mesh from, onto;
  /// Where each vertex of `onto` lies on `from`.
  SurfaceMap onto_to_from;
  /// Where each vertex of `from` lies on `onto`.
  SurfaceMap from_to_onto;
};

/// Reads the result of a match. Where it holds the map from source to target only, the other one is
/// made by `invert_map`. Throws `BadFile`.
TransferJob load_transfer(const TransferArguments& arguments, const Context& context);

}  // namespace isomatch::cli
