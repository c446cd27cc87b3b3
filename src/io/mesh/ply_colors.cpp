// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/mesh/ply_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

namespace isomatch::mesh_io {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"red", "green", "blue"};
/// Intensities that were computed exceed the full one by rounding.
constexpr double kRounding = 1.001;
constexpr double kFullByte = 255, kFullWord = 65535;

template <class T>
double largest() {
  return std::numeric_limits<T>::max();
}

/// What stands for full intensity in numbers that reach `highest` and tell nothing by their type.
double full_float(const InputFile& file, double highest) {
  for (const double full : {1.0, kFullByte, kFullWord})
    if (highest <= full * kRounding) return full;
  file.fail(fmt::format("colours reach {}, but are expected up to 1, 255 or 65535", highest));
}

}  // namespace

PlyColors::PlyColors(const PlyElement& vertex) {
  std::array<int, 3> found{};
  for (const PlyProperty& property : vertex.properties) {
    const auto name = std::ranges::find(kNames, property.name);
    const bool is_channel = name != kNames.end() && !property.count_type;
    channels_.push_back(is_channel ? static_cast<int>(name - kNames.begin()) : kNoChannel);
    if (!is_channel) continue;
    types_[channels_.back()] = property.type;
    ++found[channels_.back()];
  }
  if (std::ranges::count(found, 1) != 3) channels_.clear();
}

double PlyColors::highest(PlyType type) const {
  double result = 0;
  for (int k = 0; k < 3; ++k)
    if (types_[k] == type)
      for (const Eigen::Vector3d& color : colors_) result = std::max(result, color[k]);
  return result;
}

double PlyColors::full_intensity(const InputFile& file, PlyType type) const {
  switch (type) {
    case PlyType::kInt8:
      return largest<std::int8_t>();
    case PlyType::kUint8:
      return largest<std::uint8_t>();
    case PlyType::kInt16:
      return largest<std::int16_t>();
    case PlyType::kUint16:
      return largest<std::uint16_t>();
    case PlyType::kInt32:
      return highest(type) <= kFullByte ? kFullByte : largest<std::int32_t>();
    case PlyType::kUint32:
      return highest(type) <= kFullByte ? kFullByte : largest<std::uint32_t>();
    case PlyType::kFloat32:
    case PlyType::kFloat64:
      break;
  }
  return full_float(file, highest(type));
}

VertexColors PlyColors::take(const InputFile& file) {
  Eigen::Vector3d full;
  for (int k = 0; k < 3; ++k) full[k] = full_intensity(file, types_[k]);
  for (Eigen::Vector3d& color : colors_)
    color = color.cwiseQuotient(full).cwiseMax(0.0).cwiseMin(1.0);
  return std::move(colors_);
}

}  // namespace isomatch::mesh_io
