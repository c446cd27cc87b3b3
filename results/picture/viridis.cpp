// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/picture/viridis.h"

#include <algorithm>
#include <cmath>

namespace isomatch::picture {

Color viridis(double share) {
  // The polynomial through matplotlib's viridis of viewer/src/color/scales.ts, in sRGB.
  static const Eigen::Matrix<double, 7, 3> coefficients{
      {0.2777273272, 0.0054073445, 0.3340998053},   {0.1050930431, 1.4046135299, 1.3845901626},
      {-0.3308618287, 0.2148475595, 0.095095163},   {-4.634230499, -5.7991009734, -19.3324409563},
      {6.2282699363, 14.1799333668, 56.6905526007}, {4.7763849977, -13.7451453777, -65.3530326334},
      {-5.4354558559, 4.6458526122, 26.3124352496}};
  const double t = std::clamp(share, 0.0, 1.0);
  Eigen::RowVector3d srgb = Eigen::RowVector3d::Zero();
  for (auto k = coefficients.rows(); k-- > 0;) srgb = srgb * t + coefficients.row(k);
  return srgb.transpose().unaryExpr([](double channel) {
    return linear_intensity(
        static_cast<unsigned char>(std::lround(255 * std::clamp(channel, 0.0, 1.0))));
  });
}

}  // namespace isomatch::picture
