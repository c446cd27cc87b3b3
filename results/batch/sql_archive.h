// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

struct sqlite3;

namespace isomatch::results {

/// A file in an archive, as it is stored.
struct ArchiveEntry {
  std::string name;
  /// Of the file, in bytes.
  std::size_t size = 0;
  /// Compressed (zlib format), or as it is if that is no smaller.
  std::string data;
};

ArchiveEntry archive_entry(std::string name, std::string content);

/// An SQLite Archive: a database with a table of files, which `sqlite3 -A` lists and extracts. Who
/// reads it sees all files that were added at once or none of them, wherever the one who wrote them
/// was killed. Several processes and threads may use one. All throws `BadFile`, if the file cannot
/// be opened, is no such archive or is damaged, or if another process locks it for long.
class SqlArchive {
 public:
  enum class Access { kRead, kWrite };

  /// To write, makes it if it is not there.
  SqlArchive(const std::string& path, Access access);

  /// The names of all files whose names end so, in any order.
  std::vector<std::string> names_with_ending(const std::string& ending) const;

  std::optional<std::string> content(const std::string& name) const;

  /// Adds files at once. False, and nothing is added, if there is a file named `unless`.
  bool add(const std::vector<ArchiveEntry>& entries, const std::string& unless);

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  class Statement;

  /// Throws what an error code of SQLite means.
  void check(int code) const;
  void run(const char* command) const;
  void add_all(const std::vector<ArchiveEntry>& entries) const;

  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
  mutable std::mutex mutex_;
};

}  // namespace isomatch::results
