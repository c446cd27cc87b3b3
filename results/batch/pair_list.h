// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

/// Which pairs of shapes a batch matches.
namespace isomatch::results {

/// A pair, and the folder in which its results go, seen from that of the batch.
struct ListedPair {
  std::string source, target, name;
};

/// The pairs of a text or CSV file: a line each, source, target and, if wanted, a name, between
/// them a tab, comma or semicolon, or blanks if there is none of these. Files are seen from the
/// folder of the list. Fields may be between quotes, as CSV has them. Column names in the first
/// line
/// (`source`), blank lines and comments behind # are passed over. Without a name it is that of both
/// files, `a__b`. Throws `BadFile`, with the line, where there are fewer or more fields, where a
/// name cannot be that of a folder or is there twice, and where there is no pair.
std::vector<ListedPair> read_pairs(const std::string& path);

/// Of all meshes in a folder, by their names: every ordered pair; `center` onto each of the
/// others; each onto the next. Throw `BadFile` if the folder cannot be read or has too few meshes.
std::vector<ListedPair> all_pairs(const std::string& folder);
std::vector<ListedPair> star_of_pairs(const std::string& center, const std::string& folder);
std::vector<ListedPair> chain_of_pairs(const std::string& folder);

}  // namespace isomatch::results
