// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/group_page_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isomatch/error.h"

namespace isomatch::results {
namespace {

void check_sizes(const GroupPageMember& member, std::size_t points) {
  const bool fits = member.points.size() == points &&
                    (member.present.empty() || member.present.size() == points) &&
                    (member.spread.empty() || member.spread.size() == points);
  if (!fits)
    throw InvalidInput(fmt::format(
        "{} does not have a point for each of the template's {} vertices", member.name, points));
}

void check_numbers(const GroupPageMember& member) {
  if (!std::isfinite(member.cycle_error))
    throw InvalidInput(fmt::format("the cycle error of {} is not finite", member.name));
  for (std::size_t p = 0; p < member.points.size(); ++p) {
    if (!member.present.empty() && !member.present[p]) continue;
    const bool spread_ok =
        member.spread.empty() || (std::isfinite(member.spread[p]) && member.spread[p] >= 0);
    if (!member.points[p].allFinite() || !spread_ok)
      throw InvalidInput(fmt::format("point {} of {} is not finite", p, member.name));
  }
}

bool is_within(const GroupPair& pair, int members) {
  const auto is_member = [&](int shape) { return shape >= 0 && shape < members; };
  return is_member(pair.source) && is_member(pair.target);
}

void check_model(const ShapeModel& model, std::size_t points, std::size_t members) {
  const auto modes = model.variances.size();
  const bool fits = model.mean.size() == points && model.modes.rows() >= modes &&
                    model.modes.cols() == static_cast<Eigen::Index>(3 * points) &&
                    model.scores.rows() == static_cast<Eigen::Index>(members) &&
                    model.scores.cols() >= modes;
  if (!fits) throw InvalidInput("the model of the shapes is not one of their points");
}

}  // namespace

void check_group_page(const GroupPageData& data) {
  const auto count = static_cast<int>(data.members.size());
  if (count == 0) throw InvalidInput("a collection without shapes has no page");
  if (data.template_shape < 0 || data.template_shape >= count)
    throw InvalidInput(fmt::format("there is no shape {} for a template", data.template_shape));
  if (!std::ranges::all_of(data.pairs, [&](const auto& pair) { return is_within(pair, count); }))
    throw InvalidInput("a pair is not one of the collection's shapes");
  for (const GroupPageMember& member : data.members) {
    check_sizes(member, data.template_mesh.vertices.size());
    check_numbers(member);
  }
  if (data.model)
    check_model(data.model->model, data.template_mesh.vertices.size(), data.members.size());
}

}  // namespace isomatch::results
