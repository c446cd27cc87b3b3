// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "results/files/input_files.h"
#include "results/json.h"

/// How isomatch knows its own files in a folder: by a list of them, which is there as well.
namespace isomatch::results {

/// The reports that list files: of a match; of a match that did not get to its end, which lists
/// what it was going to write; of a transfer of poses.
inline constexpr const char* kReport = "report.json";
inline constexpr const char* kUnfinished = "unfinished.json";
inline constexpr const char* kTransfer = "transfer.json";

/// The page of a result, in its folder.
inline constexpr const char* kPage = "report.html";

/// Of what a list is: a match and a transfer into the same folder leave each other's files alone.
enum class Listing { kOfMatch, kOfTransfer };

/// The files that isomatch wrote into `folder`, seen from there, as its reports list them, and the
/// reports themselves. Names that lead out of the folder, straight or by links, are left out.
std::vector<std::string> written_files(const std::string& folder, Listing listing);

/// Throws `BadFile` if one of `names`, seen from `folder`, is a file that such a run of isomatch
/// did not write there, a link, or one of `inputs`, or if something else than a file or folder is
/// in its way.
void check_replaceable(const std::string& folder, const std::vector<std::string>& names,
                       Listing listing, const InputFiles& inputs);

/// Writes `report` with the list of `files` and its own name as `name` into `folder`. Returns what
/// it wrote.
Json write_listing(const std::string& folder, const std::string& name, Json report,
                   std::vector<std::string> files);

/// `report` with a file more in its list.
Json with_file(Json report, const std::string& name);

/// Adds a file to the list of the report.json in `folder`, which holds `report`.
void list_in_report(const std::string& folder, const Json& report, const std::string& name);

}  // namespace isomatch::results
