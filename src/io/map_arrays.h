// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "io/input_file.h"
#include "isomatch/io/map_file.h"

/// The .npz form of maps, see map_file.h.
namespace isomatch {

MapContent read_map_arrays(const std::string& path, const MapChecks& checks);
void write_map_arrays(const std::string& path, const MapContent& map);

/// Throws `BadFile` if a map of `length` vertices does not fit the source, or any.
void check_map_length(const InputFile& file, std::size_t length, const MapChecks& checks);

}  // namespace isomatch
