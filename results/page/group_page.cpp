// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/group_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "geometry/rotation.h"
#include "results/page/display_mesh.h"
#include "results/page/group_page_check.h"
#include "results/page/packed_geometry.h"
#include "results/page/template.h"

namespace isomatch::results {
namespace {

/// In the order of `PairUse`.
constexpr std::array<std::string_view, 3> kUses{"agrees", "runner-up", "composed"};

template <class Value>
std::vector<Value> at_points(const DisplayMesh& shown, const std::vector<Value>& of_template) {
  std::vector<Value> values;
  values.reserve(shown.input_vertex.size());
  for (int v : shown.input_vertex) values.push_back(of_template[v]);
  return values;
}

/// Of the faces whose corners are all there.
double area_present(const Mesh& mesh, const std::vector<bool>& present) {
  Mesh part{mesh.vertices, {}};
  std::ranges::copy_if(mesh.faces, std::back_inserter(part.faces), [&](const Face& face) {
    return std::ranges::all_of(face, [&](int v) { return present[v]; });
  });
  return surface_area(part);
}

/// Packs shapes by the points of the template that are shown.
class GroupPacking {
 public:
  explicit GroupPacking(const GroupPageData& data)
      : data_(data),
        shown_(display_mesh(data.template_mesh, kMaxGroupVertices)),
        view_(choose_mesh_view(data.template_mesh, data.view)) {
    for (const GroupPageMember& member : data.members)
      for (float spread : member.spread)
        spread_max_ = std::max(spread_max_, static_cast<double>(spread));
  }

  double spread_max() const { return spread_max_; }
  ArrayPacker& packer() { return packer_; }

  Json add_template() {
    const Mesh& mesh = shown_.mesh;
    packer_.add("template/numbers",
                std::vector<std::uint32_t>(shown_.input_vertex.begin(), shown_.input_vertex.end()),
                4, ArrayPacker::Layout::kDelta);
    add_faces(packer_, "template", mesh.faces);
    Json json = add_points(packer_, "template/position", mesh.vertices);
    json.update({{"member", data_.template_shape},
                 {"vertices", mesh.num_vertices()},
                 {"vertices_given", data_.template_mesh.num_vertices()},
                 {"simplified", shown_.simplified},
                 {"area", surface_area(mesh)},
                 {"view", to_json(view_)}});
    return json;
  }

  Json add_member(const GroupPageMember& member, const std::string& name) {
    const std::vector<bool> present = member.present.empty()
                                          ? std::vector<bool>(shown_.input_vertex.size(), true)
                                          : at_points(shown_, member.present);
    Json json = add_shape(name + "/position", at_points(shown_, member.points), present);
    std::vector<double> spread(present.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t p = 0; p < present.size(); ++p)
      if (present[p]) spread[p] = member.spread.empty() ? 0 : member.spread[shown_.input_vertex[p]];
    add_distances(packer_, name + "/spread", spread, spread_max_);
    json.update({{"name", member.name},
                 {"grade", to_string(member.grade)},
                 {"reasons", member.reasons},
                 {"cycle_error", member.cycle_error}});
    return json;
  }

  /// A shape's points and how it is shown: with as large a surface as that of the template where
  /// both have one, turned as the template.
  Json add_shape(const std::string& name, std::vector<Point> points,
                 const std::vector<bool>& present) {
    const auto first = std::ranges::find(present, true);
    const Point inside = first == present.end() ? Point(0, 0, 0) : points[first - present.begin()];
    std::vector<Point> from, to;
    for (std::size_t p = 0; p < points.size(); ++p) {
      if (present[p]) {
        from.push_back(shown_.mesh.vertices[p]);
        to.push_back(points[p]);
      } else {
        // What is missing must not stretch the box.
        points[p] = inside;
      }
    }
    Json json = add_points(packer_, name, points);
    json["area"] = whole_area(points, present);
    json["view"] = to_json(
        from.empty() ? view_ : Eigen::Matrix3d(view_ * best_rotation(from, to).transpose()));
    json["missing"] = points.size() - from.size();
    return json;
  }

  Json add_model(const ShapeModel& model) {
    Json json = add_shape("model/mean", at_points(shown_, model.mean),
                          std::vector<bool>(shown_.input_vertex.size(), true));
    const double total = model.variances.sum();
    const auto count = std::min<Eigen::Index>(kMaxShownModes, model.variances.size());
    json["modes"] = Json::array();
    for (Eigen::Index k = 0; k < count; ++k) {
      Json mode = add_points(packer_, "model/modes/" + std::to_string(k), deviation(model, k));
      mode["share"] = total > 0 ? model.variances[k] / total : 0;
      mode["scores"] = scores(model, k);
      json["modes"].push_back(std::move(mode));
    }
    return json;
  }

  Json colors() const {
    const picture::PositionColors colors(view_, data_.template_mesh.vertices);
    return {{"axes", to_json(colors.axes())},
            {"low", to_json(colors.low())},
            {"size", to_json(colors.size())}};
  }

 private:
  /// The area that the shape would have if it were whole, from what there is of it.
  double whole_area(const std::vector<Point>& points, const std::vector<bool>& present) const {
    const double of_template = area_present(shown_.mesh, present);
    const double of_shape = area_present({points, shown_.mesh.faces}, present);
    const double whole = surface_area(shown_.mesh);
    return of_template > 0 && of_shape > 0 ? whole * of_shape / of_template : whole;
  }

  /// How far one standard deviation along a mode moves each point.
  std::vector<Point> deviation(const ShapeModel& model, Eigen::Index mode) const {
    const double size = std::sqrt(std::max(0.0, model.variances[mode]));
    std::vector<Point> moves;
    for (int v : shown_.input_vertex) {
      const Eigen::Index x = 3 * static_cast<Eigen::Index>(v);
      moves.push_back(size * model.modes.row(mode).segment<3>(x).transpose());
    }
    return moves;
  }

  /// Of each shape, in standard deviations.
  static Json scores(const ShapeModel& model, Eigen::Index mode) {
    const double size = std::sqrt(std::max(0.0, model.variances[mode]));
    Json json = Json::array();
    for (Eigen::Index i = 0; i < model.scores.rows(); ++i)
      json.push_back(size > 0 ? model.scores(i, mode) / size : 0);
    return json;
  }

  const GroupPageData& data_;
  DisplayMesh shown_;
  Eigen::Matrix3d view_;
  double spread_max_ = 0;
  ArrayPacker packer_;
};

Json pairs_json(const std::vector<GroupPair>& pairs) {
  Json json = Json::array();
  for (const GroupPair& pair : pairs) {
    if (!std::isfinite(pair.cost) || !std::isfinite(pair.cycle_error)) continue;
    json.push_back({{"source", pair.source},
                    {"target", pair.target},
                    {"cost", pair.cost},
                    {"cycle_error", pair.cycle_error},
                    {"use", kUses[static_cast<std::size_t>(pair.use)]}});
  }
  return json;
}

Json to_json(const ModelQuality& quality) {
  return {{"compactness", quality.compactness},
          {"generalisation", quality.generalisation},
          {"specificity", quality.specificity}};
}

bool knows_spread(const GroupPageData& data) {
  return std::ranges::any_of(data.members,
                             [](const GroupPageMember& m) { return !m.spread.empty(); });
}

}  // namespace

PageData group_page_data(const GroupPageData& data) {
  check_group_page(data);
  GroupPacking packing(data);
  Json manifest{{"format", 1}, {"kind", "group"}, {"title", data.title}, {"command", data.command}};
  manifest["template"] = packing.add_template();
  manifest["colors"] = packing.colors();
  manifest["spread_max"] = knows_spread(data) ? Json(packing.spread_max()) : Json();
  manifest["members"] = Json::array();
  for (std::size_t k = 0; k < data.members.size(); ++k)
    manifest["members"].push_back(
        packing.add_member(data.members[k], "members/" + std::to_string(k)));
  manifest["pairs"] = pairs_json(data.pairs);
  manifest["model"] = data.model ? packing.add_model(data.model->model) : Json();
  manifest["quality"] = data.model ? to_json(data.model->quality) : Json();
  manifest["arrays"] = packing.packer().directory();
  return {std::move(manifest), packing.packer().pack()};
}

std::string group_page(const GroupPageData& data) {
  check_page_available();
  return filled_page(page_template(), group_page_data(data));
}

}  // namespace isomatch::results
