// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

/// Other mesh files hold colours as screens show them (sRGB), glTF holds linear intensities.
namespace isomatch::mesh_io {

inline double to_linear(double intensity) {
  const double c = std::clamp(intensity, 0.0, 1.0);
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

inline double to_srgb(double intensity) {
  const double c = std::clamp(intensity, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

inline Eigen::Vector3d to_linear(const Eigen::Vector3d& color) {
  return color.unaryExpr([](double c) { return to_linear(c); });
}

inline Eigen::Vector3d to_srgb(const Eigen::Vector3d& color) {
  return color.unaryExpr([](double c) { return to_srgb(c); });
}

}  // namespace isomatch::mesh_io
