// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "isomatch/atomic_file.h"
#include "isomatch/error.h"
#include "isomatch/texture_io.h"
#include "isomatch/texture_transfer.h"
#include "result/materials.h"
#include "transfer/carry.h"
#include "transfer/outputs.h"

namespace isomatch::cli {
namespace {

namespace fs = std::filesystem;

/// `path` as seen from the folder of `output`.
std::string seen_from(const std::string& output, const fs::path& path) {
  const fs::path folder = fs::absolute(output).parent_path();
  return fs::absolute(path).lexically_normal().lexically_relative(folder).generic_string();
}

/// A line of a material file in `folder` as one of the file `output`.
std::string moved_line(const std::string& line, const fs::path& folder, const std::string& output) {
  const std::optional<std::size_t> start = image_name_start(line, folder);
  if (!start) return line;
  const std::string name = line.substr(*start, line.find_last_not_of(" \t\r") + 1 - *start);
  return line.substr(0, *start) + seen_from(output, folder / name);
}

/// The materials of the texture's own files.
std::string moved_libraries(const std::string& texture, const std::string& output) {
  const fs::path folder = fs::path(texture).parent_path();
  std::string text;
  for (const std::string& name : material_libraries(texture)) {
    const fs::path path = folder / name;
    std::ifstream file(path);
    if (!file) throw BadFile(path.string(), fmt::format("cannot be opened; {} names it", texture));
    for (std::string line; std::getline(file, line);)
      text += moved_line(line, path.parent_path(), output) + "\n";
  }
  return text;
}

/// One material that shows the image.
std::string image_library(const std::string& name, const std::string& image,
                          const std::string& output) {
  return fmt::format("newmtl {}\nKd 1 1 1\nmap_Kd {}\n", name, seen_from(output, image));
}

/// With `image` all that is covered has one material.
void use_one_material(Texture& texture) {
  texture.materials = {"textured"};
  for (std::size_t f = 0; f < texture.face_material.size(); ++f)
    texture.face_material[f] = texture.covers(static_cast<int>(f)) ? 0 : Texture::kNone;
}

constexpr std::string_view kUncovered = "newmtl none\nKd 0.5 0.5 0.5\n";

}  // namespace

void carry_texture(const TransferJob& job, const TransferArguments& arguments) {
  TexturedMesh from = read_textured_mesh(arguments.texture);
  if (from.mesh.faces != job.from.faces || from.mesh.num_vertices() != job.from.num_vertices())
    throw BadFile(arguments.texture,
                  "does not have the vertices and faces of the mesh that was matched");
  const fs::path library = material_output(arguments.output);
  std::string materials;
  if (arguments.image.empty()) {
    materials = moved_libraries(arguments.texture, library.string());
  } else {
    use_one_material(from.texture);
    materials = image_library("textured", arguments.image, library.string());
  }
  const TexturedMesh carried = transfer_texture(job.from, from.texture, job.onto, job.onto_to_from,
                                                {.cut_seams = !arguments.keep_faces});
  AtomicFile file(library.string());
  file.write(materials);
  file.write(kUncovered);
  write_textured_mesh(arguments.output, carried, library.filename().string());
  file.commit();
}

}  // namespace isomatch::cli
