// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/batch_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/version.h"
#include "results/batch/sql_archive.h"
#include "results/batch/unfinished.h"
#include "results/files/outputs.h"
#include "results/files/written_files.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBatch = "batch.json";

void check(const fs::path& path, const char* what, const std::error_code& error) {
  if (error) throw BadFile(path.string(), fmt::format("cannot be {}: {}", what, error.message()));
}

/// Null where it is no JSON.
template <class Text>
Json parsed(Text&& text) {
  Json json = Json::parse(std::forward<Text>(text), nullptr, false);
  return json.is_discarded() ? Json() : json;
}

Json read_json(const fs::path& path) {
  std::ifstream file(path);
  return parsed(file);
}

Json batch_json(const Json& options) { return {{"isomatch", kVersion}, {"options", options}}; }

/// Whether two names are those of one file, be it there or not.
bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return a == b || fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

bool is_of(const Json& report, const ListedPair& pair, const Json& options) {
  const fs::path before = get_path(report, "working_folder"), now = fs::current_path();
  return report.at("isomatch") == kVersion && report.at("options") == options &&
         same_file(before / get_path(report.at("source"), "file"), now / pair.source) &&
         same_file(before / get_path(report.at("target"), "file"), now / pair.target);
}

std::vector<fs::path> archives_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> archives;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (is_archive_name(entry->path().filename().string())) archives.push_back(entry->path());
  check(folder, "read", error);
  std::ranges::sort(archives);
  return archives;
}

}  // namespace

bool is_archive_name(const std::string& name) {
  return name.starts_with("results") && name.ends_with(".sqlar");
}

BatchFolder::BatchFolder(const std::string& path, const Json& options)
    : path_(path), options_(options) {
  const fs::path file = path_ / kBatch;
  if (!is_taken(file)) throw BadFile(path, "holds no batch");
  if (read_json(file) != batch_json(options))
    throw BadFile(path,
                  "holds a batch of other options or of another version: choose another folder");
  const std::string ending = std::string("/") + kReport;
  for (const fs::path& archive : archives_in(path_))
    for (const std::string& name :
         SqlArchive(archive.string(), SqlArchive::Access::kRead).names_with_ending(ending))
      packed_.emplace(name.substr(0, name.size() - ending.size()), archive);
}

BatchFolder BatchFolder::begun(const std::string& path, const Json& options,
                               const std::vector<std::string>& files, bool go_on) {
  check_folder_name(path);
  const fs::path folder(path), file = folder / kBatch;
  if (is_taken(file)) {
    if (!go_on) throw BadFile(path, "holds a batch already: --resume goes on with it");
    remove_left_over(folder);
    return {path, options};
  }
  for (const std::string& name : files)
    if (is_taken(folder / name))
      throw BadFile((folder / name).string(),
                    "isomatch did not write this file and does not overwrite it");
  std::error_code error;
  fs::create_directories(folder, error);
  check(folder, "created", error);
  AtomicFile content(file.string());
  content.write(batch_json(options).dump(2) + "\n");
  content.commit();
  return {path, options};
}

std::optional<Json> BatchFolder::report_of(const ListedPair& pair) const {
  fs::path place = path_ / pair.name;
  Json report;
  if (is_taken(place)) {
    report = read_json(place / kReport);
  } else if (const auto packed = packed_.find(pair.name); packed != packed_.end()) {
    const SqlArchive archive(packed->second.string(), SqlArchive::Access::kRead);
    report = parsed(archive.content(pair.name + "/" + kReport).value_or(""));
    place = packed->second / pair.name;
  } else {
    return std::nullopt;
  }
  try {
    if (is_of(report, pair, options_)) return report;
  } catch (const Json::exception&) {
    throw BadFile(place.string(), "is in the way: it is no whole result; remove it");
  }
  throw BadFile(place.string(), "is in the way: it is the result of other shapes or options");
}

}  // namespace isomatch::results
