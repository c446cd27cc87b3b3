// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "match/result_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "isomatch/atomic_file.h"
#include "isomatch/error.h"

namespace isomatch::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> kResults = {
    "correspondence.txt",   "levels.json",
    "registered.ply",       "report.html",
    "report.json",          "source_to_target.bary.txt",
    "source_to_target.txt", "target_to_source.bary.txt",
    "target_to_source.txt"};

bool is_result(const std::string& name) { return std::ranges::count(kResults, name) > 0; }

bool is_number(const std::string& name) {
  return std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

/// levels/KK.*.txt of the paper's method.
bool is_level(const std::string& name) {
  return is_number(name.substr(0, name.find('.'))) &&
         (name.ends_with(".correspondence.txt") || name.ends_with(".many_to_one.txt"));
}

[[noreturn]] void fail(const fs::path& path, const char* what, const std::error_code& error) {
  throw BadFile(path.string(), fmt::format("cannot be {}: {}", what, error.message()));
}

/// What is directly in `folder`; nothing if it is no folder.
std::vector<fs::path> entries(const fs::path& folder) {
  if (!fs::is_directory(folder)) return {};
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  if (error) fail(folder, "read", error);
  std::vector<fs::path> paths;
  for (const fs::directory_entry& found : entry) paths.push_back(found.path());
  return paths;
}

void remove_entry(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) fail(path, "removed", error);
}

template <class Predicate>
void remove_files(const fs::path& folder, const Predicate& belongs) {
  for (const fs::path& path : entries(folder)) {
    if (belongs(path.filename().string()) && !fs::is_directory(path)) remove_entry(path);
  }
}

void remove_folder_if_empty(const fs::path& folder) {
  if (fs::is_directory(folder) && entries(folder).empty()) remove_entry(folder);
}

void remove_results(const fs::path& folder) {
  remove_files(folder, is_result);
  remove_files(folder / "levels", is_level);
  remove_folder_if_empty(folder / "levels");
  for (const fs::path& alternative : entries(folder / "alternatives")) {
    if (!is_number(alternative.filename().string())) continue;
    remove_files(alternative, is_result);
    remove_folder_if_empty(alternative);
  }
  remove_folder_if_empty(folder / "alternatives");
}

void create_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, "created", error);
}

}  // namespace

ResultFolder::ResultFolder(const std::string& path) : path_(path) {
  create_folder(path_);
  remove_results(path_);
}

std::string ResultFolder::add(const std::string& name) {
  const fs::path file = path_ / name;
  create_folder(file.parent_path());
  files_.push_back(name);
  return file.string();
}

void ResultFolder::write_report(Json report) {
  Json files = files_;
  files.push_back("report.json");
  report["files"] = files;
  write_json("report.json", report);
}

void ResultFolder::write_json(const std::string& name, const Json& json) {
  AtomicFile file(add(name));
  file.write(json.dump(2) + "\n");
  file.commit();
}

}  // namespace isomatch::cli
