// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "programs.h"

namespace isomatch::test {

std::string isomatch_program() { return ISOMATCH_PROGRAM; }
std::string program_without_page() { return ISOMATCH_PROGRAM_WITHOUT_PAGE; }
std::string bench_program() { return ISOMATCH_BENCH_PROGRAM; }

}  // namespace isomatch::test
