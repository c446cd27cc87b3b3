// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace isomatch::results {

/// Is told, at once, what is odd about the file `path`; one line.
using Warn = std::function<void(const std::string& path, std::string_view warning)>;

}  // namespace isomatch::results
