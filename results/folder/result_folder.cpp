// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/folder/result_folder.h"

#include <fmt/format.h>

#include <algorithm>

#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/version.h"
#include "results/files/outputs.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* what, const std::error_code& error) {
  throw BadFile(path.string(), fmt::format("cannot be {}: {}", what, error.message()));
}

void create_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail(path, "created", error);
}

/// What the run may replace or remove: its plan and what earlier runs left.
std::vector<std::string> touched_files(const ResultPlan& plan) {
  std::vector<std::string> names = written_files(plan.folder, Listing::kOfMatch);
  names.insert(names.end(), plan.files.begin(), plan.files.end());
  names.insert(names.end(), {kReport, kUnfinished});
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  return names;
}

/// Removes a file and the folders that it leaves empty, below `folder`.
void remove_file(const fs::path& folder, const fs::path& name) {
  std::error_code error;
  fs::remove(folder / name, error);
  if (error) fail(folder / name, "removed", error);
  for (fs::path parent = name.parent_path(); !parent.empty(); parent = parent.parent_path())
    if (!fs::remove(folder / parent, error)) return;
}

}  // namespace

void check_plan(const ResultPlan& plan) {
  check_folder_output(plan.folder);
  std::vector<std::string> names = touched_files(plan);
  std::erase_if(names,
                [&](const std::string& name) { return std::ranges::count(plan.ready, name) > 0; });
  check_replaceable(plan.folder, names, Listing::kOfMatch, plan.inputs);
}

ResultFolder::ResultFolder(const ResultPlan& plan) : path_(plan.folder), files_(plan.ready) {
  create_folder(path_);
  check_plan(plan);
  const std::vector<std::string> earlier = written_files(plan.folder, Listing::kOfMatch);
  // From here on all of these count as written by isomatch, wherever the run ends.
  write_listing(plan.folder, kUnfinished, {{"isomatch", kVersion}}, touched_files(plan));
  for (const std::string& name : earlier)
    if (name != kUnfinished && std::ranges::count(plan.ready, name) == 0) remove_file(path_, name);
}

std::string ResultFolder::add(const std::string& name) {
  const fs::path file = path_ / name;
  create_folder(file.parent_path());
  files_.push_back(name);
  return file.string();
}

Json ResultFolder::write_report(Json report) {
  Json listed = write_listing(path_.string(), kReport, std::move(report), files_);
  remove_file(path_, kUnfinished);
  return listed;
}

void ResultFolder::write_json(const std::string& name, const Json& json) {
  AtomicFile file(add(name));
  file.write(json.dump(2) + "\n");
  file.commit();
}

}  // namespace isomatch::results
