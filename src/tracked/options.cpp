// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/options.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

#include "isomatch/error.h"
#include "tracked/option_list.h"

namespace isomatch::tracked {
namespace {

/// Numbers of which none would leave nothing to work on, or divide by zero.
bool must_be_positive(std::string_view name) {
  for (const std::string_view ending :
       {"vertices",        "proxy.nodes",     "measured_nodes", "coarse_nodes",
        "middle_nodes",    "functions",       "landmarks",      "max_maps",
        "_length",         "entrants",        "finalists",      "first_basis",
        "roots",           "contacts.valley", "neighbours",     "relief_scales.0",
        "relief_scales.1", "relief_scales.2", "landmark_reach", "tolerable",
        "_points",         "_pair",           "_bin",           "close",
        "stiffness",       "longest",         "held",           "ring",
        "twisted"})
    if (name.ends_with(ending)) return true;
  return false;
}

}  // namespace

void Options::validate() const {
  Options copy = *this;
  for_each_number(copy, [](const std::string& name, auto& value) {
    const auto number = static_cast<double>(value);
    if (!std::isfinite(number) || number < 0 || (number == 0 && must_be_positive(name)))
      throw InvalidInput(fmt::format("the option {} is out of range: {}", name, number));
  });
  if (pyramid.coarse_nodes > pyramid.proxy.nodes || pyramid.middle_nodes > pyramid.proxy.nodes)
    throw InvalidInput("the coarse levels have more nodes than the fine one");
  // Mending looks at distances from all nodes of the middle level.
  if (pyramid.middle_nodes > pyramid.proxy.measured_nodes)
    throw InvalidInput("the middle level has more nodes than distances are measured from");
}

}  // namespace isomatch::tracked
