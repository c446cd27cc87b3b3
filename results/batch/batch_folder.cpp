// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/batch_folder.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <utility>

#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/version.h"
#include "results/files/outputs.h"
#include "results/files/written_files.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* kBatch = "batch.json";
constexpr std::string_view kUnfinishedEnding = ".unfinished";

void check(const fs::path& path, const char* what, const std::error_code& error) {
  if (error) throw BadFile(path.string(), fmt::format("cannot be {}: {}", what, error.message()));
}

/// Null where a file is no JSON.
Json read_json(const fs::path& path) {
  std::ifstream file(path);
  const Json json = Json::parse(file, nullptr, false);
  return json.is_discarded() ? Json() : json;
}

std::string host() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// What unfinished results of processes of this machine end with, before the number of the process.
std::string mark_of_host() { return fmt::format(".{}-", host()); }

/// Hidden, so that no one takes it for results.
std::string unfinished_name(const std::string& pair) {
  return fmt::format(".{}{}{}{}", pair, mark_of_host(), getpid(), kUnfinishedEnding);
}

/// Whether such results are of a process of this machine that is gone.
bool is_left_over(std::string_view name) {
  const std::string mark = mark_of_host();
  const auto at = name.rfind(mark);
  if (!name.starts_with('.') || !name.ends_with(kUnfinishedEnding) || at == std::string_view::npos)
    return false;
  const std::string_view number =
      name.substr(at + mark.size(), name.size() - at - mark.size() - kUnfinishedEnding.size());
  int process = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), process);
  return error == std::errc() && end == number.data() + number.size() && process != getpid() &&
         kill(process, 0) != 0 && errno == ESRCH;
}

void remove_left_over(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    if (is_left_over(entry->path().filename().string())) fs::remove_all(entry->path(), ignored);
  }
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

}  // namespace

BatchFolder::BatchFolder(const std::string& path, const Json& options)
    : path_(path), options_(options) {
  const fs::path file = path_ / kBatch;
  if (!is_taken(file)) throw BadFile(path, "holds no batch");
  if (read_json(file) != batch_json(options))
    throw BadFile(path,
                  "holds a batch of other options or of another version: choose another folder");
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
  const fs::path folder = path_ / pair.name;
  if (!is_taken(folder)) return std::nullopt;
  const Json report = read_json(folder / kReport);
  try {
    if (is_of(report, pair, options_)) return report;
  } catch (const Json::exception&) {
    throw BadFile(folder.string(), "is in the way: it is no whole result; remove it");
  }
  throw BadFile(folder.string(), "is in the way: it is the result of other shapes or options");
}

std::string BatchFolder::place_for(const std::string& pair) const {
  return (path_ / unfinished_name(pair)).string();
}

bool BatchFolder::finish(const std::string& pair) const {
  std::error_code error;
  fs::rename(place_for(pair), path_ / pair, error);
  if (error == std::errc::directory_not_empty || error == std::errc::file_exists) {
    abandon(pair);
    return false;
  }
  check(path_ / pair, "created", error);
  return true;
}

void BatchFolder::abandon(const std::string& pair) const noexcept {
  try {
    std::error_code ignored;
    fs::remove_all(place_for(pair), ignored);
  } catch (...) {  // Out of memory: it stays, hidden.
  }
}

}  // namespace isomatch::results
