// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/npz.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "isomatch/error.h"

namespace isomatch {
namespace {

struct Close {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, Close>;
using Entry = std::unique_ptr<zip_file_t, Close>;
using Source = std::unique_ptr<zip_source_t, Close>;

class ZipError {
 public:
  ZipError() { zip_error_init(&error_); }
  ~ZipError() { zip_error_fini(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;

  zip_error_t* get() { return &error_; }
  std::string message() { return zip_error_strerror(&error_); }

 private:
  zip_error_t error_;
};

Archive open(const InputFile& file) {
  ZipError error;
  Source source(zip_source_buffer_create(file.begin(), file.content().size(), 0, error.get()));
  if (!source) file.fail(error.message());
  Archive archive(zip_open_from_source(source.get(), ZIP_RDONLY, error.get()));
  if (!archive) file.fail("is not an .npz file: " + error.message());
  // It belongs to the archive now.
  source.release();
  return archive;
}

/// All bytes of an entry, checked against its checksum by the library.
std::string unpacked(const InputFile& file, zip_t* archive, zip_uint64_t index,
                     const std::string& name) {
  const Entry entry(zip_fopen_index(archive, index, 0));
  const auto fail = [&](const std::string& reason) {
    file.fail(fmt::format("array {} cannot be unpacked: {}", in_quotes(name), reason));
  };
  if (!entry) fail(zip_strerror(archive));
  constexpr std::size_t kFirstPiece = 1 << 16;
  std::string bytes;
  std::size_t filled = 0;
  while (true) {
    bytes.resize(std::max(kFirstPiece, 2 * filled));
    const zip_int64_t count = zip_fread(entry.get(), &bytes[filled], bytes.size() - filled);
    if (count < 0) fail(zip_file_strerror(entry.get()));
    if (count == 0) break;
    filled += count;
  }
  bytes.resize(filled);
  return bytes;
}

/// `contents` must live until the archive is written.
void add(zip_t* archive, const std::string& name, const std::string& content) {
  Source source(zip_source_buffer(archive, content.data(), content.size(), 0));
  const zip_int64_t index =
      source ? zip_file_add(archive, name.c_str(), source.get(), ZIP_FL_ENC_UTF_8) : -1;
  if (index < 0) throw InternalError("zip: " + std::string(zip_strerror(archive)));
  source.release();
  // 1980, the first date there is.
  if (zip_file_set_dostime(archive, index, 0, 1 << 5 | 1, 0) != 0)
    throw InternalError("zip: " + std::string(zip_strerror(archive)));
}

/// What was written to `source`.
std::string content_of(zip_source_t* source) {
  ZipError error;
  zip_stat_t status;
  zip_stat_init(&status);
  if (zip_source_stat(source, &status) != 0 || zip_source_open(source) != 0)
    throw InternalError("zip: nothing was written");
  std::string bytes(status.size, '\0');
  const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (std::cmp_not_equal(count, bytes.size())) throw InternalError("zip: cannot be read again");
  return bytes;
}

}  // namespace

NpzArrays read_npz(const InputFile& file) {
  constexpr std::string_view kEnding = ".npy";
  const Archive archive = open(file);
  NpzArrays arrays;
  const zip_int64_t entries = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < entries; ++i) {
    const char* const given = zip_get_name(archive.get(), i, 0);
    std::string name = given ? given : "";
    if (!name.ends_with(kEnding)) continue;
    name.resize(name.size() - kEnding.size());
    if (auto array = parse_npy(file, name, unpacked(file, archive.get(), i, name)))
      arrays[name] = std::move(*array);
  }
  return arrays;
}

void write_npy_files(const std::map<std::string, std::string>& contents, AtomicFile& file) {
  ZipError error;
  const Source source(zip_source_buffer_create(nullptr, 0, 0, error.get()));
  if (!source) throw InternalError("zip: " + error.message());
  // One reference is the archive's.
  zip_source_keep(source.get());
  Archive archive(zip_open_from_source(source.get(), ZIP_CREATE | ZIP_TRUNCATE, error.get()));
  if (!archive) throw InternalError("zip: " + error.message());
  for (const auto& [name, content] : contents) add(archive.get(), name + ".npy", content);
  if (zip_close(archive.get()) != 0)
    throw InternalError("zip: " + std::string(zip_strerror(archive.get())));
  archive.release();
  file.write(content_of(source.get()));
}

void write_npz(const NpzArrays& arrays, AtomicFile& file) {
  std::map<std::string, std::string> contents;
  for (const auto& [name, array] : arrays) contents[name] = npy_bytes(array);
  write_npy_files(contents, file);
}

}  // namespace isomatch
