// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/files/written_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "results/files/outputs.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

std::vector<const char*> reports_of(Listing listing) {
  if (listing == Listing::kOfTransfer) return {kTransfer};
  return {kReport, kUnfinished};
}

/// Whether it is a report of isomatch's that lists files.
bool is_own(const Json& json) {
  return json.is_object() && json.contains("isomatch") && json.contains("files");
}

/// Such a report; nothing if the file is none.
std::optional<Json> read_own(const fs::path& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  Json json = Json::parse(file, nullptr, false);
  if (!is_own(json)) return std::nullopt;
  return json;
}

std::vector<std::string> files_of(const Json& report) {
  try {
    return get_paths(report, "files");
  } catch (const Json::exception&) {
    return {};
  }
}

/// Whether `name` stays below `folder`, also if folders are links.
bool is_inside(const fs::path& folder, const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  if (path.empty() || path.is_absolute() || *path.begin() == "..") return false;
  std::error_code error;
  const fs::path parent = fs::weakly_canonical(folder / path.parent_path(), error);
  if (error) return false;
  const fs::path from = fs::weakly_canonical(folder, error).lexically_normal();
  const fs::path relative = parent.lexically_relative(from);
  return !error && !relative.empty() && *relative.begin() != "..";
}

/// Fails if a folder of `name` is something else.
void check_folders(const fs::path& folder, const fs::path& name) {
  fs::path path = folder;
  for (const fs::path& part : name.parent_path()) {
    path /= part;
    if (is_taken(path) && !fs::is_directory(path))
      throw BadFile(path.string(), "is not a folder, which is needed here");
  }
}

}  // namespace

std::vector<std::string> written_files(const std::string& folder, Listing listing) {
  std::vector<std::string> files;
  for (const char* name : reports_of(listing)) {
    const std::optional<Json> report = read_own(fs::path(folder) / name);
    if (!report) continue;
    files.emplace_back(name);
    for (const std::string& file : files_of(*report))
      if (is_inside(folder, file)) files.push_back(fs::path(file).lexically_normal().string());
  }
  std::ranges::sort(files);
  files.erase(std::ranges::unique(files).begin(), files.end());
  return files;
}

void check_replaceable(const std::string& folder, const std::vector<std::string>& names,
                       Listing listing, const InputFiles& inputs) {
  const std::vector<std::string> written = written_files(folder, listing);
  for (const std::string& name : names) {
    const fs::path path = fs::path(folder) / name;
    check_folders(folder, name);
    if (!is_taken(path)) continue;
    inputs.refuse(path.string());
    if (fs::is_symlink(path)) throw BadFile(path.string(), "is a link to another file");
    if (fs::is_directory(path)) throw BadFile(path.string(), "is a folder");
    if (!std::ranges::binary_search(written, fs::path(name).lexically_normal().string()))
      throw BadFile(path.string(),
                    "isomatch did not write this file and does not overwrite it; choose another "
                    "output or move it away");
  }
}

Json write_listing(const std::string& folder, const std::string& name, Json report,
                   std::vector<std::string> files) {
  if (std::ranges::count(files, name) == 0) files.push_back(name);
  set_paths(report, "files", files);
  AtomicFile file((fs::path(folder) / name).string());
  file.write(report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  file.commit();
  return report;
}

Json with_file(Json report, const std::string& name) {
  std::vector<std::string> files = files_of(report);
  // The report itself stays the last of the list.
  if (std::ranges::count(files, name) == 0) files.insert(std::ranges::find(files, kReport), name);
  set_paths(report, "files", files);
  return report;
}

void list_in_report(const std::string& folder, const Json& report, const std::string& name) {
  if (!is_own(report) || std::ranges::count(files_of(report), name) > 0) return;
  const Json listed = with_file(report, name);
  write_listing(folder, kReport, listed, files_of(listed));
}

}  // namespace isomatch::results
