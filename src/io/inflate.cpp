// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "io/inflate.h"

#include <algorithm>

#include "isomatch/error.h"

namespace isomatch {

Inflater::Inflater(std::string_view data) {
  // zlib takes no constant pointers, but does not write to its input.
  stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(data.data()));
  stream_.avail_in = static_cast<uInt>(data.size());
  if (inflateInit(&stream_) != Z_OK) throw InternalError("zlib cannot be used");
}

Inflater::~Inflater() { inflateEnd(&stream_); }

std::string Inflater::take(std::size_t size) {
  constexpr std::size_t kFirstPiece = 1 << 16;
  std::string bytes;
  std::size_t filled = 0;
  int status = Z_OK;
  while (filled < size && status == Z_OK) {
    bytes.resize(std::min(size, std::max(kFirstPiece, 2 * filled)));
    stream_.next_out = reinterpret_cast<Bytef*>(&bytes[filled]);
    const std::size_t room = std::min<std::size_t>(bytes.size() - filled, 1U << 30);
    stream_.avail_out = static_cast<uInt>(room);
    status = inflate(&stream_, Z_NO_FLUSH);
    filled += room - stream_.avail_out;
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace isomatch
