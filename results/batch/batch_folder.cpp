// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/batch_folder.h"

#include <fmt/format.h>

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

void check(const fs::path& path, const char* what, const std::error_code& error) {
  if (error) throw BadFile(path.string(), fmt::format("cannot be {}: {}", what, error.message()));
}

Json read_json(const fs::path& path) {
  std::ifstream file(path);
  try {
    return Json::parse(file);
  } catch (const Json::exception& error) {
    throw BadFile(path.string(), error.what());
  }
}

void check_same_batch(const fs::path& file, const Json& batch, bool go_on) {
  const std::string folder = file.parent_path().string();
  if (!go_on) throw BadFile(folder, "holds a batch already: --resume goes on with it");
  if (read_json(file) != batch)
    throw BadFile(folder,
                  "holds a batch of other options or of another version: choose another folder");
}

}  // namespace

BatchFolder::BatchFolder(const std::string& path, const Json& options, bool go_on) : path_(path) {
  const Json batch{{"isomatch", kVersion}, {"options", options}};
  const fs::path file = path_ / kBatch;
  if (is_taken(file)) {
    check_same_batch(file, batch, go_on);
    return;
  }
  std::error_code error;
  fs::create_directories(path_, error);
  check(path_, "created", error);
  AtomicFile content(file.string());
  content.write(batch.dump(2) + "\n");
  content.commit();
}

std::optional<Json> BatchFolder::report_of(const std::string& pair) const {
  const fs::path file = path_ / pair / kReport;
  if (!is_taken(file)) return std::nullopt;
  return read_json(file);
}

std::string BatchFolder::begin(const std::string& pair) const {
  if (is_taken(path_ / pair))
    throw BadFile((path_ / pair).string(), "is in the way: it is no finished result of this batch");
  abandon(pair);
  return unfinished(pair).string();
}

void BatchFolder::finish(const std::string& pair) const {
  std::error_code error;
  fs::rename(unfinished(pair), path_ / pair, error);
  check(path_ / pair, "created", error);
}

void BatchFolder::abandon(const std::string& pair) const {
  std::error_code error;
  fs::remove_all(unfinished(pair), error);
  check(unfinished(pair), "removed", error);
}

/// Hidden, so that no one takes it for results.
fs::path BatchFolder::unfinished(const std::string& pair) const {
  return path_ / ("." + pair + ".unfinished");
}

}  // namespace isomatch::results
