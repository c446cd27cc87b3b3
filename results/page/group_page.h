// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isomatch/group/group.h"
#include "isomatch/group/shape_model.h"
#include "results/drawing/pair_view.h"
#include "results/page/filled_page.h"

namespace isomatch::results {

/// A shape of a collection, as its page shows it.
struct GroupPageMember {
  std::string name;
  FitGrade grade = FitGrade::kGood;
  /// Why it is not good, a clause each.
  std::vector<std::string> reasons;
  /// Mean of its pairs, see `GroupPair`.
  double cycle_error = 0;
  /// Where each vertex of the template lies.
  std::vector<Point> points;
  /// Which of the points it has; all if empty.
  std::vector<bool> present;
  /// See `GroupMember::spread`; empty if it is not known.
  std::vector<float> spread;
};

/// What tells of the shapes of a collection as a whole.
struct GroupPageModel {
  ShapeModel model;
  ModelQuality quality;
};

/// All that the page of a collection shows.
struct GroupPageData {
  std::string title;
  /// As the shell takes it apart; empty if there is none.
  std::vector<std::string> command;
  Mesh template_mesh;
  /// Which member it is.
  int template_shape = 0;
  std::vector<GroupPageMember> members;
  /// Of indices into `members`. Those without a finite error are not drawn.
  std::vector<GroupPair> pairs;
  /// Its points are the vertices of the template.
  std::optional<GroupPageModel> model;
  /// From where the template is looked at; the others are turned as it is.
  ViewOptions view;
};

/// Vertices of the template that are shown at most, about: a hundred shapes have that many each.
inline constexpr int kMaxGroupVertices = 10000;
/// Principal modes with a slider.
inline constexpr int kMaxShownModes = 8;

/// Packs all that the page needs; `viewer/src/group/manifest.ts` has the fields of the manifest.
/// Points are the vertices of the template that are shown. Arrays, n their number:
/// - template/numbers, template/position (3n), template/corner0, corner1, corner2;
/// - for member K: members/K/position (3n); members/K/spread (n), steps of the manifest's
///   spread_max, none where the point is missing;
/// - if there is a model: model/mean (3n); for mode K: model/modes/K (3n), by how far one standard
///   deviation moves each point.
/// They are stored as packed_geometry.h says. Throws `InvalidInput` if there are no members, if
/// sizes do not fit, a number is not finite, a pair or the template is not among the members, or an
/// option is out of range.
PageData group_page_data(const GroupPageData& data);

/// The page as HTML. Throws as `check_page_available` and `group_page_data`.
std::string group_page(const GroupPageData& data);

}  // namespace isomatch::results
