// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/page_data.h"

#include "results/drawing/drawable.h"
#include "results/drawing/nearest_images.h"
#include "results/drawing/pair_confidence.h"
#include "results/page/array_packer.h"
#include "results/page/display_mesh.h"
#include "results/page/packed_geometry.h"

namespace isomatch::results {
namespace {

using Values = std::vector<std::uint32_t>;
using Layout = ArrayPacker::Layout;

/// Adds to a page's arrays, in the numbers of the vertices shown.
class Packing {
 public:
  Packing(const MatchResult& result, ArrayPacker& packer)
      : packer_(packer),
        source_(display_mesh(result.source)),
        target_(display_mesh(result.target)) {}

  const DisplayMesh& source() const { return source_; }
  const DisplayMesh& target() const { return target_; }

  Json add_mesh(const std::string& name, const Mesh& given, const DisplayMesh& display,
                const Eigen::Matrix3d& view) {
    packer_.add(name + "/numbers", Values(display.input_vertex.begin(), display.input_vertex.end()),
                4, Layout::kDelta);
    add_faces(packer_, name, display.mesh.faces);
    Json json = add_points(packer_, name + "/position", display.mesh.vertices);
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
  add_shares(packing.packer(), name + "/source_confidence",
             packing.at_shown(packing.source(), confidence->source));
  add_shares(packing.packer(), name + "/target_confidence",
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
  Json json{{"folder", map.folder},
            {"image", add_points(packing.packer(), name + "/image", image)}};
  packing.packer().add(name + "/partner", partners, 4, Layout::kDelta);
  packing.packer().add(name + "/back", back, 4, Layout::kDelta);
  if (!map.registered.empty())
    json["registered"] = add_points(packing.packer(), name + "/registered",
                                    packing.at_shown(source, map.registered));
  json["d_iso_max"] =
      add_distances(packing.packer(), name + "/d_iso", packing.at_shown(source, measures.d_iso));
  if (!measures.error.empty())
    json["error_max"] =
        add_distances(packing.packer(), name + "/error", packing.at_shown(source, measures.error));
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
          {"d_iso_max", add_distances(packing.packer(), name + "/d_iso", level.distortion)}};
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
