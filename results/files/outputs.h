// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/files/input_files.h"

/// What stands against an output, to be found out before any work.
namespace isomatch::results {

/// Whether something has this name, be it a link that leads nowhere.
bool is_taken(const std::filesystem::path& path);

/// The ending of `path`, with its dot and without capitals.
std::string lower_ending(const std::string& path);

/// Throws `BadFile` if `folder` is named like a file, and is not there yet.
void check_folder_name(const std::string& folder);

/// Throws `BadFile` unless `path` ends with one of `endings`, in capitals or not.
void check_ending(const std::string& path, const std::vector<std::string>& endings);

/// Throws `BadFile` if the file `output` is one of `inputs` or cannot be written. Leaves no trace.
void check_output(const std::string& output, const InputFiles& inputs);

/// The same for a file whose name the user did not give, only that of `main`, beside which it goes.
/// It is only replaced along with `main`.
void check_companion_output(const std::string& output, const std::string& main,
                            const InputFiles& inputs);

/// Throws `BadFile` unless `folder` is a folder in which files can be created, or can be created
/// itself, in a folder that is there. Leaves no trace.
void check_folder_output(const std::string& folder);

}  // namespace isomatch::results
