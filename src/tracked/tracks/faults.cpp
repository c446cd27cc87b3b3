// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/faults.h"

#include <algorithm>
#include <limits>

#include "geometry/hat_gradients.h"

namespace isomatch::tracked {

Faults::Faults(const Mesh& rest) : rest_(rest), hinges_(hinges(rest)) {
  for (const Face& face : rest.faces) {
    areas_.push_back(area_vector(rest.vertices, face).norm());
    total_ += areas_.back();
  }
}

std::vector<double> Faults::operator()(const std::vector<Point>& positions) const {
  // Margins over a right angle and over a tenth of the area, so that no rounding of coordinates
  // undoes what was mended.
  constexpr double kLeastCosine = 0.02, kLeastArea = 0.13;
  constexpr double kAny = 0.2;  // That a face is sound is worth as much as a turn by 12 degrees.
  std::vector<Point> normals;
  std::vector<double> areas, faults(areas_.size(), 0.0);
  double total = 0;
  for (const Face& face : rest_.faces) {
    normals.push_back(area_vector(positions, face));
    areas.push_back(normals.back().norm());
    total += areas.back();
  }
  for (const auto& [f, g, sign] : hinges_) {
    const double size = areas[f] * areas[g] + std::numeric_limits<double>::min();
    const double depth = kLeastCosine - sign * normals[f].dot(normals[g]) / size;
    if (depth <= 0) continue;
    faults[f] = std::max(faults[f], kAny + depth);
    faults[g] = std::max(faults[g], kAny + depth);
  }
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const double least = kLeastArea * total * areas_[f] / total_;
    if (areas[f] < least) faults[f] = std::max(faults[f], kAny + 1 - areas[f] / least);
  }
  return faults;
}

}  // namespace isomatch::tracked
