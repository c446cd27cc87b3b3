// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/sql_archive.h"

#include <sqlite3.h>
#include <zlib.h>

#include <filesystem>
#include <string_view>
#include <utility>

#include "isomatch/error.h"

namespace isomatch::results {
namespace {

std::string deflated(const std::string& content) {
  uLongf size = compressBound(content.size());
  std::string data(size, '\0');
  if (compress(reinterpret_cast<Bytef*>(data.data()), &size,
               reinterpret_cast<const Bytef*>(content.data()), content.size()) != Z_OK)
    throw InternalError("zlib cannot compress a file for an archive");
  data.resize(size);
  return data;
}

/// None if the data is not that of a file of this size.
std::optional<std::string> inflated(std::string data, std::size_t size) {
  // No file is compressed to less than one part of so many: the size of a damaged entry is not to
  // be believed.
  constexpr std::size_t kMostRatio = 1100;
  if (data.size() == size) return data;
  if (size / kMostRatio > data.size()) return std::nullopt;
  std::string content(size, '\0');
  uLongf length = size;
  const int code = uncompress(reinterpret_cast<Bytef*>(content.data()), &length,
                              reinterpret_cast<const Bytef*>(data.data()), data.size());
  if (code != Z_OK || length != size) return std::nullopt;
  return content;
}

constexpr const char* kDamaged = "is no SQLite archive, or is damaged";

}  // namespace

ArchiveEntry archive_entry(std::string name, std::string content) {
  std::string data = deflated(content);
  const std::size_t size = content.size();
  return {std::move(name), size, data.size() < size ? std::move(data) : std::move(content)};
}

/// A command with values to fill in.
class SqlArchive::Statement {
 public:
  Statement(const SqlArchive& archive, const char* command) : archive_(archive) {
    sqlite3_stmt* statement = nullptr;
    archive.check(sqlite3_prepare_v2(archive.database_.get(), command, -1, &statement, nullptr));
    statement_.reset(statement);
  }

  /// Values live until the next row is there.
  void bind(int place, const std::string& text) {
    archive_.check(sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(),
                                       SQLITE_STATIC, SQLITE_UTF8));
  }
  void bind_bytes(int place, const std::string& bytes) {
    archive_.check(
        sqlite3_bind_blob64(statement_.get(), place, bytes.data(), bytes.size(), SQLITE_STATIC));
  }
  void bind(int place, std::size_t number) {
    archive_.check(sqlite3_bind_int64(statement_.get(), place, static_cast<sqlite3_int64>(number)));
  }

  /// Whether there is a further row.
  bool step() {
    const int code = sqlite3_step(statement_.get());
    if (code != SQLITE_DONE && code != SQLITE_ROW) archive_.check(code);
    return code == SQLITE_ROW;
  }
  void reset() { sqlite3_reset(statement_.get()); }

  std::string bytes(int column) const {
    const auto* data = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
    const int size = sqlite3_column_bytes(statement_.get(), column);
    return data ? std::string(data, static_cast<std::size_t>(size)) : std::string();
  }
  std::int64_t number(int column) const { return sqlite3_column_int64(statement_.get(), column); }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };

  const SqlArchive& archive_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

void SqlArchive::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

SqlArchive::SqlArchive(const std::string& path, Access access) : path_(path) {
  constexpr int kPatienceMs = 10'000;
  // What a killed process left half written is undone by who reads next, who needs to write for it.
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX |
                    (access == Access::kWrite ? SQLITE_OPEN_CREATE : 0);
  // An absolute path is no URI and none of SQLite's special names.
  const std::string absolute = std::filesystem::absolute(path).string();
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(absolute.c_str(), &database, flags, nullptr);
  database_.reset(database);
  check(code);
  check(sqlite3_busy_timeout(database, kPatienceMs));
  if (access == Access::kWrite)
    run("CREATE TABLE IF NOT EXISTS sqlar("
        "name TEXT PRIMARY KEY, mode INT, mtime INT, sz INT, data BLOB)");
}

std::vector<std::string> SqlArchive::names_with_ending(const std::string& ending) const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::string> names;
  // One that was killed at once has left an empty file.
  if (!Statement(*this, "SELECT 1 FROM sqlite_schema").step()) return names;
  Statement statement(*this, "SELECT name FROM sqlar");
  while (statement.step())
    if (std::string name = statement.bytes(0); name.ends_with(ending))
      names.push_back(std::move(name));
  return names;
}

std::optional<std::string> SqlArchive::content(const std::string& name) const {
  const std::scoped_lock lock(mutex_);
  Statement statement(*this, "SELECT sz, data FROM sqlar WHERE name = ?");
  statement.bind(1, name);
  if (!statement.step()) return std::nullopt;
  const std::int64_t size = statement.number(0);
  std::optional<std::string> content;
  if (size >= 0) content = inflated(statement.bytes(1), static_cast<std::size_t>(size));
  if (!content) throw BadFile(path_, kDamaged);
  return content;
}

bool SqlArchive::add(const std::vector<ArchiveEntry>& entries, const std::string& unless) {
  const std::scoped_lock lock(mutex_);
  run("BEGIN IMMEDIATE");
  try {
    Statement known(*this, "SELECT 1 FROM sqlar WHERE name = ?");
    known.bind(1, unless);
    const bool is_new = !known.step();
    known.reset();
    if (is_new) add_all(entries);
    run("COMMIT");
    return is_new;
  } catch (...) {
    // Some errors have undone all already: then this is one more, which says nothing.
    sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

void SqlArchive::check(int code) const {
  if (code == SQLITE_OK) return;
  const int kind = code & 0xff;
  if (kind == SQLITE_NOMEM) throw std::bad_alloc();
  if (kind == SQLITE_BUSY) throw BadFile(path_, "is locked by another process");
  // Of the commands here, only one for a table that is not there is in error.
  if (kind == SQLITE_NOTADB || kind == SQLITE_CORRUPT || kind == SQLITE_ERROR)
    throw BadFile(path_, kDamaged);
  throw BadFile(path_, database_ ? sqlite3_errmsg(database_.get()) : sqlite3_errstr(code));
}

void SqlArchive::run(const char* command) const { Statement(*this, command).step(); }

void SqlArchive::add_all(const std::vector<ArchiveEntry>& entries) const {
  // A plain file, and no time, so that the same results are the same bytes.
  Statement statement(*this,
                      "INSERT OR REPLACE INTO sqlar(name, mode, mtime, sz, data) "
                      "VALUES(?, 33188, 0, ?, ?)");
  for (const ArchiveEntry& entry : entries) {
    statement.bind(1, entry.name);
    statement.bind(2, entry.size);
    statement.bind_bytes(3, entry.data);
    statement.step();
    statement.reset();
  }
}

}  // namespace isomatch::results
