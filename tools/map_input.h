// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>

#include "isomatch/io/map_file.h"

namespace isomatch::cli {

/// The numbering that --one-based tells.
std::optional<Numbering> told_numbering(bool one_based);

/// A sentence for users about the numbering of the map `path`, if it was neither told nor follows
/// from the ending.
std::optional<std::string> numbering_note(const std::string& path, const MapReadReport& report,
                                          bool one_based);

}  // namespace isomatch::cli
