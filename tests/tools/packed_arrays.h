// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/page/filled_page.h"

namespace isomatch::results {

std::string from_base64(std::string_view text);

/// The bytes that `ArrayPacker::pack` compressed.
std::string inflated(const std::string& packed);

/// An array of a page as `viewer/src/data/arrays.ts` unpacks it.
std::vector<std::uint32_t> unpacked(const PageData& page, const std::string& name);

}  // namespace isomatch::results
