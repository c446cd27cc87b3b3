// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "results/page/group_page.h"

namespace isomatch::results {

/// Throws `InvalidInput` as `group_page_data` but for the options of the view.
void check_group_page(const GroupPageData& data);

}  // namespace isomatch::results
