// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "map_input.h"

#include <fmt/format.h>

namespace isomatch::cli {

std::optional<Numbering> told_numbering(bool one_based) {
  return one_based ? std::optional(Numbering::kFromOne) : std::nullopt;
}

std::optional<std::string> numbering_note(const std::string& path, const MapReadReport& report,
                                          bool one_based) {
  if (report.is_assumed)
    return fmt::format("{}: taken as numbered from zero; if it is not, say --one-based", path);
  if (one_based || report.numbering == Numbering::kFromZero || is_vts_file_name(path))
    return std::nullopt;
  return fmt::format("{}: numbered from one, since it names the vertex past the last", path);
}

}  // namespace isomatch::cli
