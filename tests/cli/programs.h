// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

/// Where the programs are. Functions and no macros, so that objects of tests do not depend on it.
namespace isomatch::test {

std::string isomatch_program();
/// As it is where there is no Node.js.
std::string program_without_page();
std::string bench_program();

}  // namespace isomatch::test
