// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/canvas.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "isomatch/error.h"

namespace isomatch::picture {
namespace {

/// Samples a pixel in each direction.
constexpr int kSamples = 3;

/// Light that a surface of this normal (in the viewer's frame, either way round) sends back: much
/// of it from all around, so that colours stay comparable, the rest from the upper left.
float shade(Eigen::Vector3f normal) {
  static const Eigen::Vector3f light = Eigen::Vector3f(-0.4F, 0.7F, 1).normalized();
  const float length = normal.norm();
  if (length == 0) return 1;
  if (normal.z() < 0) normal = -normal;
  const float facing = normal.z() / length;
  return 0.22F + 0.6F * std::max(0.0F, normal.dot(light) / length) + 0.25F * facing;
}

/// Samples [first, last) of `count` whose places, half-integers, lie in [low, high].
struct SampleRange {
  int first, last;
};

SampleRange covered(float low, float high, int count) {
  const auto limit = static_cast<float>(count);
  return {static_cast<int>(std::clamp(std::ceil(low - 0.5F), 0.0F, limit)),
          static_cast<int>(std::clamp(std::floor(high - 0.5F) + 1, 0.0F, limit))};
}

}  // namespace

struct Canvas::Corner {
  /// In samples, x right, y down, z towards the viewer.
  Eigen::Vector3f place;
  Eigen::Vector3f normal;
  /// A colour, or what it follows from.
  Eigen::Vector3f look{0, 0, 0};
};

Canvas::Canvas(int width, int height, const Color& background) : width_(width), height_(height) {
  constexpr int kMaxSide = 20000;
  if (std::min(width, height) < 1 || std::max(width, height) > kMaxSide)
    throw InvalidInput("a picture's sides must be between 1 and 20000 pixels");
  const std::size_t count = static_cast<std::size_t>(width) * height * kSamples * kSamples;
  samples_.assign(count, background);
  depth_.assign(count, -std::numeric_limits<float>::infinity());
}

void Canvas::draw(const Mesh& mesh, std::span<const Color> colors, const Projection& projection) {
  if (colors.size() != mesh.vertices.size())
    throw InvalidInput("drawing needs a colour for every vertex");
  std::vector<Corner> corners = project(mesh, projection);
  for (std::size_t v = 0; v < corners.size(); ++v) corners[v].look = colors[v];
  for (const Face& face : mesh.faces)
    fill(corners[face[0]], corners[face[1]], corners[face[2]],
         [](const Eigen::Vector3f& look) -> const Color& { return look; });
}

void Canvas::draw(const Mesh& mesh, const TexturePaint& paint, const Projection& projection) {
  const Texture& texture = paint.texture;
  validate(texture, mesh);
  const std::vector<Corner> corners = project(mesh, projection);
  for (int f = 0; f < mesh.num_faces(); ++f) {
    std::array<Corner, 3> own;
    for (int k = 0; k < 3; ++k) {
      own[k] = corners[mesh.faces[f][k]];
      if (texture.covers(f))
        own[k].look.head<2>() = texture.coordinates[texture.corners[f][k]].cast<float>();
    }
    fill(own[0], own[1], own[2],
         [&](const Eigen::Vector3f& look) { return paint(f, look.head<2>()); });
  }
}

std::vector<Canvas::Corner> Canvas::project(const Mesh& mesh, const Projection& projection) {
  const std::vector<Point> normals = weighted_vertex_normals(mesh);
  std::vector<Corner> corners(mesh.vertices.size());
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const Point seen = projection.rotation * (mesh.vertices[v] - projection.focus);
    const Point place = kSamples * Point(projection.centre.x() + projection.scale * seen.x(),
                                         projection.centre.y() - projection.scale * seen.y(),
                                         projection.scale * seen.z());
    corners[v].place = place.cast<float>();
    corners[v].normal = (projection.rotation * normals[v].normalized()).cast<float>();
  }
  return corners;
}

template <class Paint>
void Canvas::fill(const Corner& a, const Corner& b, const Corner& c, const Paint& paint) {
  const auto [x0, x1] = std::minmax({a.place.x(), b.place.x(), c.place.x()});
  const auto [y0, y1] = std::minmax({a.place.y(), b.place.y(), c.place.y()});
  const auto cross = [](const Eigen::Vector3f& o, const Eigen::Vector3f& p, float x, float y) {
    return (p.x() - o.x()) * (y - o.y()) - (p.y() - o.y()) * (x - o.x());
  };
  const float area = cross(a.place, b.place, c.place.x(), c.place.y());
  const int columns = width_ * kSamples, rows = height_ * kSamples;
  const auto [left, right] = covered(x0, x1, columns);
  const auto [top, bottom] = covered(y0, y1, rows);
  if (area == 0) return;
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) {
      const float x = static_cast<float>(column) + 0.5F, y = static_cast<float>(row) + 0.5F;
      const float wa = cross(b.place, c.place, x, y) / area;
      const float wb = cross(c.place, a.place, x, y) / area;
      const float wc = 1 - wa - wb;
      if (wa < 0 || wb < 0 || wc < 0) continue;
      const std::size_t sample = static_cast<std::size_t>(row) * columns + column;
      const float depth = wa * a.place.z() + wb * b.place.z() + wc * c.place.z();
      if (depth <= depth_[sample]) continue;
      depth_[sample] = depth;
      samples_[sample] = paint(wa * a.look + wb * b.look + wc * c.look) *
                         shade(wa * a.normal + wb * b.normal + wc * c.normal);
    }
  }
}

Image Canvas::image() const {
  Image image{width_, height_, {}};
  image.pixels.assign(static_cast<std::size_t>(width_) * height_, Color::Zero());
  const std::size_t columns = static_cast<std::size_t>(width_) * kSamples;
  for (std::size_t sample = 0; sample < samples_.size(); ++sample) {
    const std::size_t x = sample % columns / kSamples, y = sample / columns / kSamples;
    image.pixels[y * width_ + x] += samples_[sample] / (kSamples * kSamples);
  }
  return image;
}

}  // namespace isomatch::picture
