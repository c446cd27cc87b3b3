// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <filesystem>
#include <string>

namespace isomatch::results {

/// What the folder is called in which this process makes the results of a pair: hidden, so that no
/// one takes it for results, and with host and process, so that no two meet.
std::string unfinished_name(const std::string& pair);

/// Removes such folders of processes of this machine that are gone, as far as that can be done.
void remove_left_over(const std::filesystem::path& folder);

}  // namespace isomatch::results
