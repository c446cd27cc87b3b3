// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "isomatch/error.h"
#include "results/batch/result_store.h"
#include "results/batch/sql_archive.h"
#include "results/files/written_files.h"

namespace isomatch::results {
namespace {

namespace fs = std::filesystem;

/// A new folder where temporary files belong, which is removed in the end.
class WorkFolder {
 public:
  WorkFolder() {
    std::error_code error;
    const fs::path parent = fs::temp_directory_path(error);
    if (error) throw BadFile("TMPDIR", "is no folder for temporary files");
    std::string name = (parent / "isomatch-batch-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw BadFile(parent.string(),
                    fmt::format("a folder in it cannot be created: {}",
                                std::error_code(errno, std::generic_category()).message()));
    path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file || !content) throw BadFile(path.string(), "cannot be read");
  return std::move(content).str();
}

/// All files in a folder, sorted by names, which begin with `pair`.
std::vector<ArchiveEntry> entries_of(const fs::path& folder, const std::string& pair) {
  std::vector<ArchiveEntry> entries;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const fs::path name = pair / entry.path().lexically_relative(folder);
    entries.push_back(archive_entry(name.generic_string(), content_of(entry.path())));
  }
  std::ranges::sort(entries, {}, &ArchiveEntry::name);
  return entries;
}

class ArchiveStore : public ResultStore {
 public:
  explicit ArchiveStore(const std::string& path) : archive_(path, SqlArchive::Access::kWrite) {}

  std::string place_for(const std::string& pair) const override { return (work_ / pair).string(); }

  bool finish(const std::string& pair) override {
    const bool added = archive_.add(entries_of(work_ / pair, pair), pair + "/" + kReport);
    abandon(pair);
    return added;
  }

  void abandon(const std::string& pair) noexcept override {
    try {
      std::error_code ignored;
      fs::remove_all(work_ / pair, ignored);
    } catch (...) {  // Out of memory: it stays until all is removed.
    }
  }

 private:
  SqlArchive archive_;
  WorkFolder work_;
};

}  // namespace

std::unique_ptr<ResultStore> archive_store(const std::string& archive) {
  return std::make_unique<ArchiveStore>(archive);
}

}  // namespace isomatch::results
