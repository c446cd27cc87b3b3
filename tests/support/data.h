// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

namespace isomatch::test {

/// Where a file or folder of the shapes that may not be redistributed is, if it is there. A
/// function and no macro, so that objects of tests do not depend on where the data lies.
std::string data_path(const std::string& name);

}  // namespace isomatch::test
