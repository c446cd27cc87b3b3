// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "support/mesh_files.h"

#include "isomatch/error.h"
#include "support/temporary_folder.h"

namespace isomatch::test {

Mesh read_content(std::string_view ending, std::string_view content, MeshReadReport* report) {
  const TemporaryFolder folder;
  return read_mesh(folder.write("mesh." + std::string(ending), content), report);
}

std::string read_error(std::string_view ending, std::string_view content) {
  const TemporaryFolder folder;
  const std::string path = folder.write("mesh." + std::string(ending), content);
  try {
    read_mesh(path);
  } catch (const BadFile& error) {
    const std::string message = error.what();
    if (!message.starts_with(path + ": ")) return "no file name in: " + message;
    return message.substr(path.size() + 2);
  }
  return "no error";
}

Mesh tetrahedron() {
  return {{Point(0, 0, 0), Point(1.5, 0, 0), Point(0, 2, 0), Point(0, 0, -0.25)},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

}  // namespace isomatch::test
