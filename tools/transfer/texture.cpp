// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "isomatch/carry/texture_transfer.h"
#include "isomatch/error.h"
#include "isomatch/io/atomic_file.h"
#include "isomatch/io/model_io.h"
#include "load.h"
#include "results/files/image_line.h"
#include "results/files/materials.h"
#include "transfer/carry.h"
#include "transfer/outputs.h"

namespace isomatch::cli {
namespace {

namespace fs = std::filesystem;

/// `path` as seen from the folder of `output`.
std::string seen_from(const std::string& output, const fs::path& path) {
  const fs::path folder = fs::absolute(output).lexically_normal().parent_path();
  return fs::absolute(path).lexically_normal().lexically_relative(folder).generic_string();
}

/// A line of a file of materials as one of the file `output`. What is not there keeps its name and
/// goes into `missing`.
std::string moved_line(const std::string& line, const results::MaterialLibrary& library,
                       const std::string& output, std::set<std::string>& missing) {
  const std::optional<results::ImageLine> image = results::image_line(line, library.path);
  if (!image) return line;
  if (!image->path.empty()) return image->before + seen_from(output, image->path) + image->after;
  missing.insert(image->name);
  return line;
}

/// What becomes of the texture's own files of materials.
struct MovedMaterials {
  std::string text;
  std::set<std::string> names;
  /// Files that are not there.
  std::vector<std::string> missing;
};

/// Appends the materials that none of the files before has.
void append(MovedMaterials& moved, const results::MaterialLibrary& library,
            const std::string& output) {
  const std::set<std::string> before = moved.names;
  std::set<std::string> missing;
  bool is_new = true;
  for (const std::string& line : library.lines) {
    if (const auto name = results::new_material(line)) {
      is_new = !before.contains(*name);
      moved.names.insert(*name);
    }
    if (is_new) moved.text += moved_line(line, library, output, missing) + "\n";
  }
  results::warn_of_images(library, missing, warn_of);
}

MovedMaterials moved_materials(const std::string& path, const Texture& texture,
                               const std::string& output) {
  const std::vector<results::MaterialLibrary> libraries = results::load_libraries(path, warn_of);
  MovedMaterials moved;
  for (const results::MaterialLibrary& library : libraries) {
    if (library.path.empty())
      moved.missing.push_back(library.name);
    else
      append(moved, library, output);
  }
  results::warn_of_materials(path, texture.materials, moved.names, libraries, warn_of);
  return moved;
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
  TexturedMesh from = load_textured_mesh(arguments.texture);
  if (from.mesh.faces != job.from.faces || from.mesh.num_vertices() != job.from.num_vertices())
    throw BadFile(arguments.texture,
                  "does not have the vertices and faces of the mesh that was matched");
  const fs::path library = material_output(arguments.output);
  MovedMaterials materials;
  if (arguments.image.empty()) {
    materials = moved_materials(arguments.texture, from.texture, library.string());
  } else {
    use_one_material(from.texture);
    materials.text = image_library("textured", arguments.image, library.string());
  }
  TexturedMesh carried = transfer_texture(job.from, from.texture, job.onto, job.onto_to_from,
                                          {.cut_seams = !arguments.keep_faces});
  AtomicFile file(library.string());
  file.write(materials.text);
  if (!materials.names.contains("none")) file.write(kUncovered);
  std::vector<std::string> libraries{library.filename().string()};
  libraries.insert(libraries.end(), materials.missing.begin(), materials.missing.end());
  write_model(arguments.output,
              {.mesh = std::move(carried.mesh), .texture = std::move(carried.texture)},
              {libraries});
  file.commit();
}

}  // namespace isomatch::cli
