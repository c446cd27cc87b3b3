// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isomatch::cli {

/// Of `known` the word that `word` may have been meant to be: one that it begins, or from which
/// few letters are missing, too many, wrong or exchanged with their neighbours. Of several as close
/// the first.
std::optional<std::string> closest_word(std::string_view word,
                                        const std::vector<std::string>& known);

}  // namespace isomatch::cli
