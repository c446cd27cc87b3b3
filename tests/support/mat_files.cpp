// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/mat_files.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>

#include "support/mesh_files.h"

namespace isomatch::test {

std::string MatWriter::header() const {
  std::string header = "MATLAB 5.0 MAT-file, a test";
  header.resize(124, ' ');
  return header + bytes<std::uint16_t>(order_, {0x0100, 'M' << 8 | 'I'});
}

std::string MatWriter::element(unsigned type, std::string content) const {
  const auto size = static_cast<std::uint32_t>(content.size());
  content.resize((content.size() + 7) / 8 * 8);
  return bytes<std::uint32_t>(order_, {type, size}) + content;
}

std::string MatWriter::array(unsigned array_class, int rows, int columns, std::string_view name,
                             const std::string& content) const {
  return element(14, element(6, bytes<std::uint32_t>(order_, {array_class, 0})) +
                         element(5, bytes<std::int32_t>(order_, {rows, columns})) +
                         element(1, std::string(name)) + content);
}

std::string MatWriter::matrix(std::string_view name, int rows, int columns,
                              const std::vector<double>& values) const {
  std::string content;
  for (const double value : values) content += bytes<double>(order_, {value});
  return array(6, rows, columns, name, element(9, content));
}

std::string MatWriter::byte_matrix(std::string_view name, int rows, int columns,
                                   const std::vector<double>& values) const {
  std::string content;
  for (const double value : values) content += static_cast<char>(value);
  return array(6, rows, columns, name, element(2, content));
}

std::string MatWriter::structure(std::string_view name, const std::vector<std::string>& field_names,
                                 const std::vector<std::string>& fields) const {
  std::string names;
  for (std::string field : field_names) {
    field.resize(32);
    names += field;
  }
  // A number of four bytes may stand in the tag: its size, then its type.
  const std::uint32_t tag = 4U << 16 | 5U;
  std::string content = bytes<std::uint32_t>(order_, {tag, 32}) + element(1, names);
  for (const std::string& field : fields) content += field;
  const int columns =
      static_cast<int>(fields.size() / std::max<std::size_t>(field_names.size(), 1));
  return array(2, 1, columns, name, content);
}

std::string MatWriter::compressed(const std::string& variable) const {
  uLongf size = compressBound(variable.size());
  std::string content(size, '\0');
  compress(reinterpret_cast<Bytef*>(content.data()), &size,
           reinterpret_cast<const Bytef*>(variable.data()), variable.size());
  content.resize(size);
  // The only elements without padding.
  return bytes<std::uint32_t>(order_, {15, static_cast<std::uint32_t>(size)}) + content;
}

std::string tetrahedron_mat(std::endian order) {
  const MatWriter mat(order);
  return mat.header() +
         mat.structure("surface", {"X", "Y", "Z", "TRIV"},
                       {mat.matrix("", 4, 1, {0, 1.5, 0, 0}), mat.matrix("", 4, 1, {0, 0, 2, 0}),
                        mat.matrix("", 4, 1, {0, 0, 0, -0.25}),
                        mat.byte_matrix("", 4, 3, {1, 1, 2, 3, 3, 2, 3, 1, 2, 4, 4, 4})});
}

}  // namespace isomatch::test
