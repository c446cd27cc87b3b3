// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/mesh/synth.h"
#include "random.h"
#include "synth/collision.h"
#include "synth/creature.h"
#include "synth/ground_truth.h"
#include "synth/holes.h"
#include "synth/plane_cut.h"
#include "synth/pose.h"
#include "synth/remains.h"
#include "synth/skin.h"

namespace isomatch {
namespace {

using namespace synth;

/// Purposes of random numbers, one stream each.
enum Stream : std::uint64_t {
  kShapeStream,
  kTemplateStream,
  kPoseStream,
  kMeshStream,
  kCutStream,
  kHoleStream
};

/// Within 2 % of the wanted number, rounding included.
int vertex_count(const SynthOptions& options, Random& random) {
  const int slack = options.vertices * 3 / 200;
  return options.vertices - slack + random.below(2 * slack + 1);
}

Pose make_pose(const Body& body, const SynthOptions& options) {
  if (options.pose == 0) return Pose(body);
  Random random{kPoseStream, options.seed, static_cast<std::uint64_t>(options.pose)};
  // Ends because at rest nothing collides.
  for (double share = 1;; share *= 0.97) {
    const Pose pose(body, share, random);
    if (!collides(body, pose)) return pose;
  }
}

std::vector<Point> template_points(const Body& body, const SynthOptions& options, Context context) {
  context.progress = {};
  Random random{kTemplateStream, options.seed};
  return mesh_skin(body, Pose(body), kSynthTemplatePoints, random, context).rest;
}

/// Puts vertices and faces in random order and starts each face at a random corner.
Skin shuffled(const Skin& skin, Random& random) {
  std::vector<int> order(skin.rest.size());
  std::iota(order.begin(), order.end(), 0);
  random.shuffle(order);
  Skin result{skin.faces, std::vector<Point>(order.size()), std::vector<Point>(order.size())};
  for (std::size_t v = 0; v < order.size(); ++v) {
    result.posed[order[v]] = skin.posed[v];
    result.rest[order[v]] = skin.rest[v];
  }
  for (Face& face : result.faces) {
    for (int& v : face) v = order[v];
    std::rotate(face.begin(), face.begin() + random.below(3), face.end());
  }
  random.shuffle(result.faces);
  return result;
}

/// Of holes, over sqrt(area); `SynthOptions::holes` says why.
constexpr double kHoleRadius = 0.05;

/// The numbers do not depend on how finely the shape is meshed.
Random removal_random(Stream stream, const SynthOptions& options) {
  return {stream, options.seed, static_cast<std::uint64_t>(options.pose)};
}

void keep(SynthShape& shape, Mesh remains) {
  shape.mesh = sound_remains(std::move(remains));
  drop_unused_vertices(shape);
}

void remove_parts(SynthShape& shape, const SynthOptions& options, const Context& context) {
  const double radius = kHoleRadius * std::sqrt(surface_area(shape.mesh));
  if (options.cut > 0) {
    Random random = removal_random(kCutStream, options);
    keep(shape, cut_by_plane(shape.mesh, options.cut, random));
  }
  if (options.holes > 0) {
    Random random = removal_random(kHoleStream, options);
    const HoleOptions holes{options.holes, radius, shape.ground_truth};
    keep(shape, make_holes(shape.mesh, holes, random, context));
  }
}

}  // namespace

std::vector<std::string> synth_shapes() { return {"creature"}; }

void SynthOptions::validate() const {
  const std::vector<std::string> shapes = synth_shapes();
  if (std::find(shapes.begin(), shapes.end(), shape) == shapes.end())
    throw InvalidInput(
        fmt::format("unknown shape '{}', known: {}", shape, fmt::join(shapes, ", ")));
  if (vertices < 1000 || vertices > 10'000'000)
    throw InvalidInput(fmt::format("vertices must be in [1000, 10000000], not {}", vertices));
  if (pose < 0) throw InvalidInput(fmt::format("pose must be at least 0, not {}", pose));
  if (!(cut >= 0 && cut <= 0.95))
    throw InvalidInput(fmt::format("cut must be in [0, 0.95], not {}", cut));
  if (holes < 0) throw InvalidInput(fmt::format("holes must be at least 0, not {}", holes));
}

SynthShape synthesize(const SynthOptions& options, const Context& context) {
  options.validate();
  Random shape_random{kShapeStream, options.seed};
  const Body body = make_creature(shape_random);
  const Pose pose = make_pose(body, options);

  Random random{kMeshStream, options.seed, static_cast<std::uint64_t>(options.pose),
                static_cast<std::uint64_t>(options.vertices)};
  const int vertices = vertex_count(options, random);
  Skin skin = shuffled(mesh_skin(body, pose, vertices, random, context), random);

  context.report(1, "ground truth");
  const std::vector<Point> points = template_points(body, options, context);
  const SurfaceLookup lookup(body, skin.rest, context);
  SynthShape result;
  result.ground_truth = lookup.nearest(points);
  std::vector<Point> images(points.size());
  std::transform(points.begin(), points.end(), images.begin(), mirrored);
  result.symmetric_ground_truth = lookup.nearest(images);
  result.mesh = {std::move(skin.posed), std::move(skin.faces)};
  result.rest = std::move(skin.rest);
  remove_parts(result, options, context);
  return result;
}

}  // namespace isomatch
