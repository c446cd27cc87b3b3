// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch {

struct SynthOptions {
  /// One of `synth_shapes()`.
  std::string shape = "creature";
  /// Wanted number of vertices, 1,000 to 10,000,000. The mesh has as many within 2 % before parts
  /// are removed; how many exactly differs from pose to pose.
  int vertices = 5000;
  /// 0 is the rest pose, in which the shape equals its mirror image; every other number bends the
  /// limbs, head, tail and spine in its own way. At least 0.
  int pose = 0;
  /// Decides the shape: number of limbs, lengths, thicknesses, ranges of the joints.
  std::uint64_t seed = 1;
  /// Share of the area that is removed: what lies beyond a plane across the posed shape, and what
  /// that leaves behind in smaller pieces. In [0, .95], so that of the smallest mesh some fifty
  /// vertices remain. Seed and pose together decide the plane's direction, so that each pose is cut
  /// in its own way. What remains is the vertices and whole faces of the uncut mesh, in their
  /// order.
  double cut = 0;
  /// Round holes, apart from each other and from the cut; seed and pose together decide where. They
  /// reach .05 sqrt(area of the uncut shape) from their middles along the surface: enough to be
  /// seen on 1,000 vertices, and less than half of what goes around the thinnest limb, which a hole
  /// thus does not sever. At least 0.
  int holes = 0;

  /// Throws `InvalidInput` if a value is out of range or the shape is unknown. Whether there is
  /// room for the holes, only `synthesize` tells.
  void validate() const;
};

/// A mesh whose correspondence to every other pose of the same shape and seed is known.
///
/// The truth refers to `kSynthTemplatePoints` points spread evenly over the rest pose, the same for
/// all poses and sizes of one shape and seed: entry i of two shapes' truths is a matching pair. Up
/// to half an edge length of noise on either side is all that separates it from the exact map. A
/// mesh with fewer vertices than template points names vertices repeatedly, a larger one not all of
/// them; `rest` gives the exact map for every vertex.
struct SynthShape {
  /// Of genus 0, oriented outwards, evenly meshed, in one piece; closed but for what `cut` and
  /// `holes` removed, whose borders are simple loops. Lengths are relative to the distance
  /// from hip to shoulder. The mirror plane of the rest pose is x = 0, y points up and z forward.
  Mesh mesh;
  /// For each vertex its place on the surface of the rest pose, exact up to rounding. Mirroring is
  /// negating x.
  std::vector<Point> rest;
  /// For each template point the nearest vertex, 0-based; `kUnmatched` if that was removed.
  std::vector<int> ground_truth;
  /// For each template point the vertex nearest to its mirror image: the left-right flipped truth.
  /// `kUnmatched` as above.
  std::vector<int> symmetric_ground_truth;
};

inline constexpr int kSynthTemplatePoints = 5000;

/// Names that `SynthOptions::shape` may take.
std::vector<std::string> synth_shapes();

/// Makes a smooth creature in a pose: a mesh of its own for every pose, with vertices and faces in
/// random order. Poses are near-isometric: between two of them geodesic distances change by about
/// one percent of the largest. Throws as `validate`, and `InvalidInput` if there is no room for the
/// holes. O(N log N); deterministic for any number of threads.
SynthShape synthesize(const SynthOptions& options, const Context& context = {});

}  // namespace isomatch
