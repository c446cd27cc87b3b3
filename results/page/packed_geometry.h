// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "isomatch/mesh/mesh.h"
#include "results/page/array_packer.h"

/// How pages store shapes and what is measured on them; viewer/src/data/decode.ts is the way back.
namespace isomatch::results {

Json to_json(const Point& point);
Json to_json(const Eigen::Matrix3d& rows);

/// All x, all y, all z as 16-bit steps of the points' box, which is returned as low and size.
Json add_points(ArrayPacker& packer, const std::string& name, std::span<const Point> points);

/// `name`/corner0, corner1, corner2; corners 1 and 2 are zigzag differences from corner 0.
void add_faces(ArrayPacker& packer, const std::string& name, const std::vector<Face>& faces);

/// The largest that is a number, at least 0.
double largest_distance(std::span<const double> distances);

/// Distances as 16-bit steps of `largest`, which none may exceed; 65535 is NaN.
void add_distances(ArrayPacker& packer, const std::string& name, std::span<const double> distances,
                   double largest);
/// Likewise, in steps of the largest, which is returned.
double add_distances(ArrayPacker& packer, const std::string& name,
                     std::span<const double> distances);

/// Shares of one as 8-bit steps of 1 / 254; 255 is NaN.
void add_shares(ArrayPacker& packer, const std::string& name, std::span<const float> shares);

}  // namespace isomatch::results
