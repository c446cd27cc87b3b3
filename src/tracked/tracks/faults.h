// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <vector>

#include "geometry/face_orientation.h"
#include "isomatch/mesh/mesh.h"

namespace isomatch::tracked {

/// Tells which faces of a mesh are folded or squeezed after its vertices have moved, as
/// `measure_registered` does, with a margin. Keeps a reference to the mesh at rest.
class Faults {
 public:
  explicit Faults(const Mesh& rest);

  /// Of each face how bad it is; zero if it is sound.
  std::vector<double> operator()(const std::vector<Point>& positions) const;

 private:
  const Mesh& rest_;
  std::vector<double> areas_;
  double total_ = 0;
  std::vector<Hinge> hinges_;
};

}  // namespace isomatch::tracked
