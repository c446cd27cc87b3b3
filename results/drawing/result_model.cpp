// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/drawing/result_model.h"

#include <cmath>

#include "results/drawing/drawable.h"
#include "results/drawing/pair_view.h"

namespace isomatch::results {
namespace {

/// As screens show it.
double to_srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

}  // namespace

Model result_model(const MatchResult& result, const ResultMap& map) {
  Model model = read_model(result.source_path);
  MatchResult drawn = result;
  make_drawable(drawn);
  const PairView view = choose_pair_view(drawn, map);
  const picture::PositionColors color(view.target, drawn.target.vertices);
  model.colors.clear();
  for (const picture::Color& linear : source_colors(drawn, map, color))
    model.colors.push_back(linear.cast<double>().unaryExpr(&to_srgb));
  model.poses.clear();
  if (!map.registered.empty()) model.poses.push_back({"registered", map.registered});
  return model;
}

}  // namespace isomatch::results
