// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/drawing/pair_view.h"

#include "geometry/rotation.h"
#include "isomatch/error.h"
#include "results/picture/view.h"

namespace isomatch::results {
namespace {

Point upward(const Mesh& mesh, const std::string& name) {
  if (name.empty()) return picture::guess_up(mesh);
  const std::optional<Point> axis = picture::parse_axis(name);
  if (!axis) throw InvalidInput("up is one of x, -x, y, -y, z, -z, not " + name);
  return *axis;
}

Eigen::Matrix3d source_to_target_rotation(const MatchResult& result, const ResultMap& map) {
  const std::vector<Point> all_images = images(result.target, map);
  std::vector<Point> from, to;
  for (int v = 0; v < result.source.num_vertices(); ++v) {
    if (!map.is_matched(v)) continue;
    from.push_back(result.source.vertices[v]);
    to.push_back(all_images[v]);
  }
  if (from.empty()) return Eigen::Matrix3d::Identity();
  return best_rotation(from, to);
}

}  // namespace

Eigen::Matrix3d choose_mesh_view(const Mesh& mesh, const ViewOptions& options) {
  return picture::choose_view(mesh, upward(mesh, options.up), options.turn);
}

PairView choose_pair_view(const MatchResult& result, const ResultMap& map,
                          const ViewOptions& options) {
  const Eigen::Matrix3d source = choose_mesh_view(result.source, options);
  return {source, source * source_to_target_rotation(result, map).transpose()};
}

std::vector<picture::Color> source_colors(const MatchResult& result, const ResultMap& map,
                                          const picture::PositionColors& color) {
  const std::vector<Point> places = images(result.target, map);
  std::vector<picture::Color> colors;
  for (int v = 0; v < result.source.num_vertices(); ++v)
    colors.push_back(map.is_matched(v) ? color(places[v]) : picture::kUnmatchedColor);
  return colors;
}

std::vector<bool> matched_targets(const Mesh& target, const Correspondence& relation) {
  std::vector<bool> matched(target.vertices.size());
  for (const Match& match : relation) matched[match.target] = true;
  return matched;
}

}  // namespace isomatch::results
