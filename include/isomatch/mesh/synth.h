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
  /// Wanted number of vertices, 1,000 to 10,000,000. The mesh has as many within 2 %; how many
  /// exactly differs from pose to pose.
  int vertices = 5000;
  /// 0 is the rest pose, in which the shape equals its mirror image; every other number bends the
  /// limbs, head, tail and spine in its own way. At least 0.
  int pose = 0;
  /// Decides the shape: number of limbs, lengths, thicknesses, ranges of the joints.
  std::uint64_t seed = 1;

  /// Throws `InvalidInput` if a value is out of range or the shape is unknown.
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
  /// Closed, of genus 0, oriented outwards, evenly meshed. Lengths are relative to the distance
  /// from hip to shoulder. The mirror plane of the rest pose is x = 0, y points up and z forward.
  Mesh mesh;
  /// For each vertex its place on the surface of the rest pose, exact up to rounding. Mirroring is
  /// negating x.
  std::vector<Point> rest;
  /// For each template point the nearest vertex, 0-based.
  std::vector<int> ground_truth;
  /// For each template point the vertex nearest to its mirror image: the left-right flipped truth.
  std::vector<int> symmetric_ground_truth;
};

inline constexpr int kSynthTemplatePoints = 5000;

/// Names that `SynthOptions::shape` may take.
std::vector<std::string> synth_shapes();

/// Makes a smooth creature in a pose: a mesh of its own for every pose, with vertices and faces in
/// random order. Poses are near-isometric: between two of them geodesic distances change by about
/// one percent of the largest. Throws as `validate`. O(N); deterministic for any number of threads.
SynthShape synthesize(const SynthOptions& options, const Context& context = {});

}  // namespace isomatch
