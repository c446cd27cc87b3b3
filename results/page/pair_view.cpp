// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/pair_view.h"

#include "geometry/rotation.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/mesh/surface.h"
#include "results/picture/view.h"

namespace isomatch::cli {
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

/// Puts each of `points` where the one that stands for it is.
void replace(const std::vector<int>& places, std::vector<Point>& points) {
  for (std::size_t v = 0; v < points.size(); ++v) points[v] = points[places[v]];
}

}  // namespace

void make_drawable(Mesh& mesh) { replace(stand_ins(mesh), mesh.vertices); }

void make_drawable(MatchResult& result) {
  const std::vector<int> places = stand_ins(result.source);
  for (ResultMap& map : result.maps) replace(places, map.registered);
  make_drawable(result.source);
  make_drawable(result.target);
}

PairView choose_pair_view(const MatchResult& result, const ResultMap& map,
                          const ViewOptions& options) {
  const Eigen::Matrix3d source =
      picture::choose_view(result.source, upward(result.source, options.up), options.turn);
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

std::vector<bool> matched_targets(const MatchResult& result) {
  std::vector<bool> matched(result.target.vertices.size());
  const MatchContent relation = read_matches(result.path("correspondence.txt"),
                                             {.source_vertices = result.source.num_vertices(),
                                              .target_vertices = result.target.num_vertices()},
                                             Numbering::kFromZero);
  for (const Match& match : relation.matches) matched[match.target] = true;
  return matched;
}

}  // namespace isomatch::cli
