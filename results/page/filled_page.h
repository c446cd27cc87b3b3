// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <string_view>

#include "results/json.h"

namespace isomatch::results {

/// What a page shows, in the form that viewer/src reads.
struct PageData {
  /// Everything that is small, and what the arrays are.
  Json manifest;
  /// The rest: an `ArrayPacker`'s block.
  std::string arrays;
};

/// Throws `InvalidInput` that says what is missing if this program was built without the page's
/// template. For use before long work.
void check_page_available();

/// `page` with the data in place of its empty data elements. Throws `InternalError` if it has none.
std::string filled_page(std::string_view page, const PageData& data);

}  // namespace isomatch::results
