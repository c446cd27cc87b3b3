// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <string_view>

#include "results/page/page_data.h"

namespace isomatch::results {

/// Throws `InvalidInput` that says what is missing if this program was built without the page's
/// template. For use before long work.
void check_page_available();

/// `page` with the data in place of its empty data elements. Throws `InternalError` if it has none.
std::string filled_page(std::string_view page, const PageData& data);

/// Throws what stands against writing the page of a result to `path`, before any work: `BadFile` if
/// it is not named .html, an input, cannot be written, or is the folder's own page and isomatch did
/// not write what is there; and as `check_page_available`.
void check_page_output(const std::string& path, const std::string& folder, const MeshPlaces& places,
                       const TruthFiles& truth);

/// Writes a page that shows `match` to `path`. The page of the match's own folder, report.html, is
/// added to the list of the folder's files. Throws `BadFile` and `InvalidInput`.
void write_page(const std::string& path, ShownMatch match, const PageOptions& options,
                const Context& context);

}  // namespace isomatch::results
