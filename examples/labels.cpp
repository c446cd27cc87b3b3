// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// Carries labels, an integer a line for each source vertex, over to the target by the map that
// `isomatch match --target-to-source` wrote.
#include <exception>
#include <iostream>
#include <vector>

#include "isomatch/carry/transfer.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/io/values_io.h"

namespace {

void carry_labels(const char* source_file, const char* target_file, const char* map_file,
                  const char* labels_file, const char* output_file) {
  const isomatch::Mesh source = isomatch::read_mesh(source_file);
  const isomatch::Mesh target = isomatch::read_mesh(target_file);
  const isomatch::SurfaceMap target_to_source =
      isomatch::read_map(
          map_file, {.source_vertices = target.num_vertices(), .target_faces = source.num_faces()})
          .points;
  const std::vector<int> labels = isomatch::read_labels(labels_file, source.num_vertices());
  isomatch::write_labels(output_file, isomatch::transfer_labels(source, target_to_source, labels));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::cerr << "usage: example_labels SOURCE TARGET TARGET_TO_SOURCE.bary.txt LABELS OUTPUT\n";
    return 2;
  }
  try {
    carry_labels(argv[1], argv[2], argv[3], argv[4], argv[5]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
