// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "results/page/filled_page.h"
#include "results/page/page_data.h"

namespace isomatch::results {

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
