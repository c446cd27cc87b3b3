// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Lines of files of materials (.mtl).
namespace isomatch::results {

/// The lines of a file of materials, which end with \n, \r\n or \r.
///
/// Throws BadFile if it cannot be read.
std::vector<std::string> material_lines(const std::string& path);

/// What the line is about; empty if it is blank.
std::string_view keyword_of(std::string_view line);

/// The name that a line `newmtl` gives: its rest without the blanks around it.
std::optional<std::string> new_material(std::string_view line);

/// A line that names an image, in three parts.
struct ImageLine {
  std::string before, name, after;
  /// The image; empty if it is not there.
  std::string path;
};

/// Nothing unless it is a line that names an image, of the file of materials `library`.
///
/// Options may stand before the name, and the name may hold blanks and #: it is the rest of the
/// line behind the options. If there is no such file, but one with less of the line, that is taken:
/// without a # behind a blank and what follows, without options at the end, or with numbers that an
/// option may have or not.
std::optional<ImageLine> image_line(const std::string& line, const std::string& library);

}  // namespace isomatch::results
