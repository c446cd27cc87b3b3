// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/data.h"

namespace isomatch::test {

std::string data_path(const std::string& name) { return ISOMATCH_TEST_DATA "/" + name; }

}  // namespace isomatch::test
