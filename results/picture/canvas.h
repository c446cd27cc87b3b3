// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <span>
#include <vector>

#include "isomatch/mesh/mesh.h"
#include "results/picture/texture_paint.h"

namespace isomatch::picture {

/// An orthographic view: where a point appears on the canvas.
struct Projection {
  /// Rows point right, up and towards the viewer; orthonormal.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  /// This point appears at the pixel coordinates `centre` (x right, y down).
  Point focus{0, 0, 0};
  Eigen::Vector2d centre{0, 0};
  /// Pixels a unit of length.
  double scale = 1;
};

/// Draws shaded, anti-aliased triangle meshes by a depth buffer.
class Canvas {
 public:
  /// Throws `InvalidInput` if a side is not in [1, 20000].
  Canvas(int width, int height, const Color& background);

  /// Draws `mesh` with a colour a vertex, lit from the viewer's upper left; both sides of a face
  /// look the same. Normals and colours are interpolated. Draw a mesh after another to see both,
  /// the nearer one in front. Throws `InvalidInput` if there are not as many colours as vertices.
  /// O(faces + covered samples).
  void draw(const Mesh& mesh, std::span<const Color> colors, const Projection& projection);

  /// The same with the colours of a texture, which must fit the mesh.
  void draw(const Mesh& mesh, const TexturePaint& paint, const Projection& projection);

  /// What has been drawn so far, samples averaged.
  Image image() const;

 private:
  struct Corner;
  static std::vector<Corner> project(const Mesh& mesh, const Projection& projection);
  template <class Paint>
  void fill(const Corner& a, const Corner& b, const Corner& c, const Paint& paint);

  int width_, height_;
  std::vector<Color> samples_;
  /// Towards the viewer, of each sample.
  std::vector<float> depth_;
};

}  // namespace isomatch::picture
