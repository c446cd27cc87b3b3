// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "isomatch/maps/correspondence.h"
#include "isomatch/maps/surface_map.h"
#include "shape/surface.h"

/// The one door between the caller's numbers of vertices and faces, in which all public functions
/// speak, and those of a surface. Whatever comes in out of range is an `InvalidInput`.
namespace isomatch {

/// Something whose vertices and faces are counted as a surface does. It does not convert to or from
/// what is in the caller's numbers.
template <class Content>
class OnSurface {
 public:
  OnSurface() = default;
  explicit OnSurface(Content content) : content_(std::move(content)) {}

  const Content& operator*() const& { return content_; }
  Content& operator*() & { return content_; }
  Content operator*() && { return std::move(content_); }
  const Content* operator->() const { return &content_; }
  Content* operator->() { return &content_; }

 private:
  Content content_;
};

using SurfaceMatches = OnSurface<Correspondence>;
using SurfacePoints = OnSurface<SurfaceMap>;
using SurfaceVertices = OnSurface<std::vector<int>>;

/// `kNoVertex` where it is not part of the surface.
int surface_vertex(const Surface& surface, int input_vertex);

/// Without those of vertices that are not part of the surfaces; copies at a seam count once.
SurfaceMatches on_surfaces(const Surface& source, const Surface& target,
                           const Correspondence& matches);

/// Of the points of copies at a seam the lowest one's counts; a point on a face that is not part of
/// the target's surface is none. Throws `InvalidInput` too if there is not a point for each vertex.
SurfacePoints on_surfaces(const Surface& source, const Surface& target, const SurfaceMap& map);

/// Of the images of copies at a seam the lowest one's counts. Throws `InvalidInput` too if there is
/// not an image, or `kUnmatched`, for each vertex.
OnSurface<VertexMap> on_surfaces(const Surface& source, const Surface& target,
                                 const VertexMap& map);

/// Vertices that have to be part of the surface; `name` begins the message if one is not.
SurfaceVertices on_surface(const Surface& surface, std::span<const int> vertices,
                           std::string_view name);

/// All copies at seams, sorted.
Correspondence to_input(const Surface& source, const Surface& target,
                        const SurfaceMatches& matches);
/// A point of the target.
SurfacePoint to_input(const Surface& target, const SurfacePoint& point);
/// Vertices that are not part of the source's surface have no point.
SurfaceMap to_input(const Surface& source, const Surface& target, const SurfacePoints& map);
/// The lowest copies.
std::vector<int> to_input(const Surface& surface, const SurfaceVertices& vertices);

/// A value for each vertex of the surface as one for each of the caller's, `missing` where it is
/// not part of it.
template <class Value>
std::vector<Value> at_input(const Surface& surface, const std::vector<Value>& values,
                            Value missing) {
  std::vector<Value> result;
  result.reserve(surface.surface_vertex.size());
  for (int v : surface.surface_vertex) result.push_back(v == kNoVertex ? missing : values[v]);
  return result;
}

/// `input` after its surface moved: `positions` holds where each vertex of the surface is now, in
/// whatever coordinates. Vertices that are not part of the surface follow the surface vertex that
/// was nearest to them, turned as those around it are.
std::vector<Point> at_input(const Mesh& input, const Surface& surface,
                            const std::vector<Point>& positions);

}  // namespace isomatch
