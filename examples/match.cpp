// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// Matches two meshes; writes the target vertex of every source vertex, and the source mesh in the
// target's pose.
#include <exception>
#include <iostream>

#include "isomatch/io/map_io.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/methods/tracked.h"

namespace {

void match(const char* source_file, const char* target_file, const char* map_file,
           const char* registered_file) {
  const isomatch::Shape source(isomatch::read_mesh(source_file));
  const isomatch::Shape target(isomatch::read_mesh(target_file));

  const isomatch::TrackedResult result = isomatch::match_tracked(source, target);
  const isomatch::TrackedMap& best = result.maps.front();
  std::cout << "ambiguity " << result.ambiguity << '\n';

  isomatch::write_source_to_target(
      map_file, isomatch::nearest_vertices(target.mesh(), best.source_to_target));
  isomatch::write_mesh(registered_file, {best.registered, source.mesh().faces});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "usage: example_match SOURCE TARGET MAP.txt REGISTERED.ply\n";
    return 2;
  }
  try {
    match(argv[1], argv[2], argv[3], argv[4]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
