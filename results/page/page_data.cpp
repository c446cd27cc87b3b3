// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/page_data.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "results/drawing/drawable.h"
#include "results/drawing/nearest_images.h"
#include "results/drawing/pair_confidence.h"
#include "results/page/array_packer.h"
#include "results/page/display_mesh.h"

namespace isomatch::results {
namespace {

using Values = std::vector<std::uint32_t>;
using Layout = ArrayPacker::Layout;

constexpr std::uint32_t kNone = 65535;
constexpr std::uint32_t kNoByte = 255;

Json to_json(const Point& point) { return {point.x(), point.y(), point.z()}; }

Json to_json(const Eigen::Matrix3d& rows) {
  Json json = Json::array();
  for (int k = 0; k < 3; ++k) json.push_back(to_json(Point(rows.row(k))));
  return json;
}

/// Adds to a page's arrays, in the numbers of the vertices shown.
class Packing {
 public:
  Packing(const MatchResult& result, ArrayPacker& packer)
      : packer_(packer),
        source_(display_mesh(result.source)),
        target_(display_mesh(result.target)) {}

  const DisplayMesh& source() const { return source_; }
  const DisplayMesh& target() const { return target_; }

  /// Points as 16-bit steps of their bounding box, which is returned as low and size.
  Json add_points(const std::string& name, const std::vector<Point>& points) {
    Eigen::AlignedBox3d box;
    for (const Point& p : points) box.extend(p);
    const Point size = box.sizes().cwiseMax(1e-300);
    Values steps;
    for (int k = 0; k < 3; ++k) {
      for (const Point& p : points)
        steps.push_back(
            static_cast<std::uint32_t>(std::lround((p[k] - box.min()[k]) / size[k] * 65535)));
    }
    packer_.add(name, steps, 2, Layout::kDelta);
    return {{"low", to_json(Point(box.min()))}, {"size", to_json(size)}};
  }

  /// Distances as steps of the largest one, which is returned.
  double add_distances(const std::string& name, const std::vector<double>& distances) {
    double largest = 0;
    for (double d : distances)
      if (d > largest) largest = d;
    Values steps;
    for (double d : distances) {
      const double share = largest > 0 ? d / largest : 0;
      steps.push_back(std::isnan(d) ? kNone
                                    : static_cast<std::uint32_t>(std::lround(share * 65534)));
    }
    packer_.add(name, steps, 2);
    return largest;
  }

  /// Shares of one as 8-bit steps.
  void add_shares(const std::string& name, const std::vector<float>& shares) {
    Values steps;
    for (float share : shares)
      steps.push_back(std::isnan(share) ? kNoByte
                                        : static_cast<std::uint32_t>(
                                              std::lround(254 * std::clamp(share, 0.0F, 1.0F))));
    packer_.add(name, steps, 1);
  }

  Json add_mesh(const std::string& name, const Mesh& given, const DisplayMesh& display,
                const Eigen::Matrix3d& view) {
    packer_.add(name + "/numbers", Values(display.input_vertex.begin(), display.input_vertex.end()),
                4, Layout::kDelta);
    Values corners[3];
    for (const Face& face : display.mesh.faces) {
      corners[0].push_back(face[0]);
      for (int k = 1; k < 3; ++k) corners[k].push_back(zigzag(face[k] - face[0]));
    }
    packer_.add(name + "/corner0", corners[0], 4, Layout::kDelta);
    packer_.add(name + "/corner1", corners[1], 4);
    packer_.add(name + "/corner2", corners[2], 4);
    Json json = add_points(name + "/position", display.mesh.vertices);
    json.update({{"vertices", display.mesh.num_vertices()},
                 {"faces", display.mesh.num_faces()},
                 {"vertices_given", given.num_vertices()},
                 {"simplified", display.simplified},
                 {"area", surface_area(given)},
                 {"view", to_json(view)}});
    return json;
  }

  template <class Value>
  std::vector<Value> at_shown(const DisplayMesh& display, const std::vector<Value>& values) const {
    std::vector<Value> shown;
    shown.reserve(display.input_vertex.size());
    for (int v : display.input_vertex) shown.push_back(values[v]);
    return shown;
  }

  ArrayPacker& packer() { return packer_; }

 private:
  ArrayPacker& packer_;
  DisplayMesh source_, target_;
};

/// Whether there is any.
bool add_confidence(Packing& packing, const MatchResult& result, const ResultMap& map,
                    const std::vector<bool>& target_matched, const std::string& name) {
  const std::optional<PairConfidence> confidence = pair_confidence(result, map, target_matched);
  if (!confidence) return false;
  packing.add_shares(name + "/source_confidence",
                     packing.at_shown(packing.source(), confidence->source));
  packing.add_shares(name + "/target_confidence",
                     packing.at_shown(packing.target(), confidence->target));
  return true;
}

Json add_map(Packing& packing, const MatchResult& result, const ResultMap& map,
             const MapMeasures& measures, const std::vector<bool>& target_matched,
             const std::string& name) {
  const DisplayMesh& source = packing.source();
  std::vector<Point> image = packing.at_shown(source, images(result.target, map));
  const VertexMap shown_map = packing.at_shown(source, map.source_to_target);
  Values partners;
  for (std::size_t v = 0; v < image.size(); ++v) {
    const int t = shown_map[v];
    partners.push_back(t == kUnmatched ? 0 : packing.target().shown_vertex[t] + 1);
    // A place that does not stretch the bounding box.
    if (t == kUnmatched) image[v] = result.target.vertices.front();
  }
  Values back;
  for (int v : nearest_images(image, shown_map, packing.target().mesh.vertices,
                              packing.at_shown(packing.target(), target_matched)))
    back.push_back(v == kUnmatched ? 0 : v + 1);
  Json json{{"folder", map.folder}, {"image", packing.add_points(name + "/image", image)}};
  packing.packer().add(name + "/partner", partners, 4, Layout::kDelta);
  packing.packer().add(name + "/back", back, 4, Layout::kDelta);
  if (!map.registered.empty())
    json["registered"] =
        packing.add_points(name + "/registered", packing.at_shown(source, map.registered));
  json["d_iso_max"] =
      packing.add_distances(name + "/d_iso", packing.at_shown(source, measures.d_iso));
  if (!measures.error.empty())
    json["error_max"] =
        packing.add_distances(name + "/error", packing.at_shown(source, measures.error));
  json["confidence"] = add_confidence(packing, result, map, target_matched, name);
  return json;
}

Json add_level(Packing& packing, const MeasuredMatches& level, const std::string& name) {
  Values sources, targets;
  for (const Match& match : level.matches) {
    sources.push_back(packing.source().shown_vertex[match.source]);
    targets.push_back(packing.target().shown_vertex[match.target]);
  }
  packing.packer().add(name + "/source", sources, 4, Layout::kDelta);
  packing.packer().add(name + "/target", targets, 4, Layout::kDelta);
  return {{"matches", level.matches.size()},
          {"d_iso_max", packing.add_distances(name + "/d_iso", level.distortion)}};
}

Json colors_json(const MatchResult& result, const PairView& view) {
  const picture::PositionColors colors(view.target, result.target.vertices);
  return {{"axes", to_json(colors.axes())},
          {"low", to_json(colors.low())},
          {"size", to_json(colors.size())}};
}

/// Maps and levels.
void add_results(Packing& packing, const ShownMatch& match,
                 const std::vector<MapMeasures>& measures, Json& manifest) {
  const MatchResult& result = match.result;
  const std::vector<bool> target_matched = matched_targets(result.target, match.relation);
  manifest["maps"] = Json::array();
  for (std::size_t k = 0; k < result.maps.size(); ++k)
    manifest["maps"].push_back(add_map(packing, result, result.maps[k], measures[k], target_matched,
                                       "maps/" + std::to_string(k)));
  manifest["levels"] = Json::array();
  for (std::size_t k = 0; k < match.levels.size(); ++k)
    manifest["levels"].push_back(
        add_level(packing, match.levels[k].many_to_many, "levels/" + std::to_string(k)));
}

}  // namespace

PageData page_data(ShownMatch match, const PageOptions& options, const Context& context) {
  MatchResult& result = match.result;
  const std::vector<MapMeasures> measures = measure_maps(match, options.truth, context);
  context.report(0.9, "writing");
  make_drawable(result);
  const PairView view = choose_pair_view(result, result.maps.front(), options.view);
  ArrayPacker packer;
  Packing packing(result, packer);
  Json manifest{{"format", 1}, {"report", result.report}, {"folder", result.folder}};
  manifest["source"] = packing.add_mesh("source", result.source, packing.source(), view.source);
  manifest["target"] = packing.add_mesh("target", result.target, packing.target(), view.target);
  manifest["colors"] = colors_json(result, view);
  manifest["truth"] = Json();
  if (!options.truth.source.empty())
    manifest["truth"] = {{"source", options.truth.source}, {"target", options.truth.target}};
  add_results(packing, match, measures, manifest);
  manifest["arrays"] = packer.directory();
  return {std::move(manifest), packer.pack()};
}

}  // namespace isomatch::results
