// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>

#include "results/folder/result.h"

namespace isomatch::cli {

/// Adds `--source` and `--target`, which tell where the meshes of a result are now.
void add_places(CLI::App& command, results::MeshPlaces& places);

}  // namespace isomatch::cli
