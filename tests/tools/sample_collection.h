// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "results/page/group_page.h"

namespace isomatch::results {

/// A made-up collection: copies of a creature, each bent, twisted and thickened in its own way. One
/// has lost a part, one is poor and two are doubtful, with pairs that were replaced. Its model is
/// that of the points as they are; all other numbers are invented. Of five shapes or more.
GroupPageData sample_collection(int shapes, int vertices);

}  // namespace isomatch::results
