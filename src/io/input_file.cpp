// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/input_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "isomatch/error.h"

namespace isomatch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kQuotedLength = 24;

/// Size of the regular file `path`. Looks before anything is opened: opening a pipe may never
/// return.
std::size_t file_size(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error) throw BadFile(path, error.message());
  if (fs::is_directory(status)) throw BadFile(path, "is a folder");
  if (!fs::is_regular_file(status)) throw BadFile(path, "not a regular file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw BadFile(path, error.message());
  if (size == 0) throw BadFile(path, "the file is empty");
  return size;
}

/// A line ends with \n, \r\n or \r.
std::size_t line_number(std::string_view before) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool lone_return = before[i] == '\r' && before.substr(i + 1, 1) != "\n";
    line += before[i] == '\n' || lone_return;
  }
  return line;
}

}  // namespace

InputFile::InputFile(std::string path)
    : path_(std::move(path)),
      size_(file_size(path_)),
      content_(std::make_unique_for_overwrite<char[]>(size_)) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path_.c_str(), "rb"),
                                                             std::fclose);
  if (!file) fail(std::generic_category().message(errno));
  if (std::fread(content_.get(), 1, size_, file.get()) != size_) fail("cannot be read to its end");
}

void InputFile::fail(const std::string& reason) const { throw BadFile(path_, reason); }

void InputFile::fail_at_line(const char* place, const std::string& reason) const {
  throw BadFile(path_, fmt::format("line {}", line_number({begin(), place})), reason);
}

void InputFile::fail_at_byte(const char* place, const std::string& reason) const {
  throw BadFile(path_, fmt::format("byte {}", place - begin()), reason);
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, kQuotedLength)) {
    const bool plain = c >= ' ' && c <= '~';
    result += plain ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return result + (text.size() > kQuotedLength ? "...'" : "'");
}

}  // namespace isomatch
