// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/packed_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isomatch::results {
namespace {

constexpr std::uint32_t kNone = 65535;
constexpr std::uint32_t kNoByte = 255;

std::uint32_t step(double share, int steps) {
  return static_cast<std::uint32_t>(std::lround(share * steps));
}

}  // namespace

Json to_json(const Point& point) { return {point.x(), point.y(), point.z()}; }

Json to_json(const Eigen::Matrix3d& rows) {
  Json json = Json::array();
  for (int k = 0; k < 3; ++k) json.push_back(to_json(Point(rows.row(k))));
  return json;
}

Json add_points(ArrayPacker& packer, const std::string& name, std::span<const Point> points) {
  Eigen::AlignedBox3d box;
  for (const Point& p : points) box.extend(p);
  const Point size = box.sizes().cwiseMax(1e-300);
  std::vector<std::uint32_t> steps;
  for (int k = 0; k < 3; ++k)
    for (const Point& p : points) steps.push_back(step((p[k] - box.min()[k]) / size[k], 65535));
  packer.add(name, steps, 2, ArrayPacker::Layout::kDelta);
  return {{"low", to_json(Point(box.min()))}, {"size", to_json(size)}};
}

void add_faces(ArrayPacker& packer, const std::string& name, const std::vector<Face>& faces) {
  std::vector<std::uint32_t> corners[3];
  for (const Face& face : faces) {
    corners[0].push_back(face[0]);
    for (int k = 1; k < 3; ++k) corners[k].push_back(zigzag(face[k] - face[0]));
  }
  packer.add(name + "/corner0", corners[0], 4, ArrayPacker::Layout::kDelta);
  packer.add(name + "/corner1", corners[1], 4);
  packer.add(name + "/corner2", corners[2], 4);
}

double largest_distance(std::span<const double> distances) {
  double largest = 0;
  for (double d : distances)
    if (d > largest) largest = d;
  return largest;
}

void add_distances(ArrayPacker& packer, const std::string& name, std::span<const double> distances,
                   double largest) {
  std::vector<std::uint32_t> steps;
  for (double d : distances)
    steps.push_back(std::isnan(d) ? kNone : step(largest > 0 ? d / largest : 0, 65534));
  packer.add(name, steps, 2);
}

double add_distances(ArrayPacker& packer, const std::string& name,
                     std::span<const double> distances) {
  const double largest = largest_distance(distances);
  add_distances(packer, name, distances, largest);
  return largest;
}

void add_shares(ArrayPacker& packer, const std::string& name, std::span<const float> shares) {
  std::vector<std::uint32_t> steps;
  for (float share : shares)
    steps.push_back(std::isnan(share) ? kNoByte : step(std::clamp(share, 0.0F, 1.0F), 254));
  packer.add(name, steps, 1);
}

}  // namespace isomatch::results
