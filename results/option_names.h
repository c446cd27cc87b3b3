// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <string_view>

#include "isomatch/option_fields.h"
#include "results/json.h"

namespace isomatch::results {

/// What the command line and reports call the option `field` of a struct: radius-factor for
/// radius_factor. `max_levels` is `levels`, since it is the number K that the paper's text gives.
std::string option_name(std::string_view field);

/// The geodesics that the program calls w20, w10 and edges. Throws `InvalidInput`.
GeodesicOptions geodesic_options(const std::string& name);

/// Adds the values of `options` to `json` under their names.
template <class Options>
void add_options(Json& json, const Options& options) {
  for_each_option(options, [&](const char* field, const auto& value, const char*) {
    json[option_name(field)] = value;
  });
}

}  // namespace isomatch::results
