// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/tessellator.h"

#include <GL/glu.h>

#include <cstdint>
#include <new>

namespace isomatch::mesh_io {
namespace {

struct Output {
  std::vector<int> corners;
  bool failed = false;
};

// GLU takes a pointer for each corner and hands it out again; numbers count from 1, as null means
// none to it.
void* to_pointer(std::size_t corner) { return reinterpret_cast<void*>(corner + 1); }
int to_corner(const void* pointer) {
  return static_cast<int>(reinterpret_cast<std::uintptr_t>(pointer)) - 1;
}

void take_corner(void* corner, void* output) {
  static_cast<Output*>(output)->corners.push_back(to_corner(corner));
}

/// Of two corners in one place, the first; there is none where edges cross.
void combine(const GLdouble*, void* const* corners, const GLfloat*, void** result, void* output) {
  *result = corners[0];
  if (corners[2] != nullptr) static_cast<Output*>(output)->failed = true;
}

void take_error(GLenum, void* output) { static_cast<Output*>(output)->failed = true; }

/// With such a callback GLU hands out single triangles, no strips and fans.
void take_edge_flag(GLboolean, void*) {}

template <class Function>
_GLUfuncptr callback(Function* function) {
  return reinterpret_cast<_GLUfuncptr>(function);
}

}  // namespace

void Tessellator::Delete::operator()(GLUtesselator* tessellator) const {
  gluDeleteTess(tessellator);
}

Tessellator::Tessellator() : tessellator_(gluNewTess()) {
  GLUtesselator* const tess = tessellator_.get();
  if (tess == nullptr) throw std::bad_alloc();
  gluTessCallback(tess, GLU_TESS_VERTEX_DATA, callback(take_corner));
  gluTessCallback(tess, GLU_TESS_COMBINE_DATA, callback(combine));
  gluTessCallback(tess, GLU_TESS_ERROR_DATA, callback(take_error));
  gluTessCallback(tess, GLU_TESS_EDGE_FLAG_DATA, callback(take_edge_flag));
  gluTessProperty(tess, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_POSITIVE);
  gluTessNormal(tess, 0, 0, 1);
}

std::optional<std::vector<Tessellator::Triangle>> Tessellator::cut(
    std::span<const Eigen::Vector2d> corners) {
  Output output;
  // Callbacks must not throw through GLU.
  output.corners.reserve(6 * corners.size());
  GLUtesselator* const tess = tessellator_.get();
  gluTessBeginPolygon(tess, &output);
  gluTessBeginContour(tess);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    std::array<GLdouble, 3> place{corners[k].x(), corners[k].y(), 0};
    gluTessVertex(tess, place.data(), to_pointer(k));
  }
  gluTessEndContour(tess);
  gluTessEndPolygon(tess);
  if (output.failed || output.corners.empty() || output.corners.size() % 3 != 0)
    return std::nullopt;
  std::vector<Triangle> triangles;
  for (std::size_t k = 0; k < output.corners.size(); k += 3)
    triangles.push_back({output.corners[k], output.corners[k + 1], output.corners[k + 2]});
  return triangles;
}

}  // namespace isomatch::mesh_io
