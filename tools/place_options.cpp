// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "place_options.h"

namespace isomatch::cli {

void add_places(CLI::App& command, results::MeshPlaces& places) {
  command.add_option("--source", places.source, "The source mesh, if it was moved")
      ->type_name("FILE");
  command.add_option("--target", places.target, "The target mesh, if it was moved")
      ->type_name("FILE");
}

}  // namespace isomatch::cli
