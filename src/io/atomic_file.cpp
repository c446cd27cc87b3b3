// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/io/atomic_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <random>
#include <system_error>
#include <utility>

#include "isomatch/error.h"

namespace isomatch {
namespace {

namespace fs = std::filesystem;

constexpr int kNameAttempts = 100;
/// As many as Linux follows.
constexpr int kMostLinks = 40;

[[noreturn]] void fail(const std::string& path, std::string_view action, std::error_code error) {
  throw BadFile(path, fmt::format("{}: {}", action, error.message()));
}

std::error_code last_error() { return {errno, std::generic_category()}; }

/// `path`, or the file that it links to, which need not exist.
fs::path follow_links(const std::string& path) {
  fs::path destination = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(fs::symlink_status(destination, error)); ++links) {
    if (links == kMostLinks) throw BadFile(path, "too many links");
    destination = destination.parent_path() / fs::read_symlink(destination, error);
  }
  return destination;
}

fs::path checked_destination(const std::string& path) {
  const fs::path destination = follow_links(path);
  std::error_code error;
  const fs::file_status status = fs::status(destination, error);
  if (fs::is_directory(status)) throw BadFile(path, "is a folder");
  // Moving a file over a device or a pipe would destroy it.
  if (fs::exists(status) && !fs::is_regular_file(status)) throw BadFile(path, "not a regular file");
  return destination;
}

fs::path temporary_name(const fs::path& destination) {
  // Short and independent of the destination's name, which may be as long as the system allows.
  std::random_device random;
  return destination.parent_path() / fmt::format(".isomatch-{:08x}.tmp", random());
}

}  // namespace

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), destination_(checked_destination(path_)) {
  for (int attempt = 0; attempt < kNameAttempts && !file_; ++attempt) {
    temporary_ = temporary_name(destination_);
    file_.reset(std::fopen(temporary_.string().c_str(), "wbx"));
    if (!file_ && errno != EEXIST) break;
  }
  if (!file_) fail(path_, "cannot be created", last_error());
}

AtomicFile::~AtomicFile() {
  file_.reset();
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view bytes) {
  if (!file_) throw InternalError(path_ + ": written after it was committed");
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
    fail(path_, "cannot be written", last_error());
}

void AtomicFile::commit() {
  if (!file_) throw InternalError(path_ + ": committed twice");
  if (std::fclose(file_.release()) != 0) fail(path_, "cannot be written", last_error());
  std::error_code error;
  fs::rename(temporary_, destination_, error);
  if (error) fail(path_, "cannot be moved into place", error);
  temporary_.clear();
}

}  // namespace isomatch
