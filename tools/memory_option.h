// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace isomatch::cli {

/// Adds --memory, in GiB, which may be no number below zero.
void add_memory_option(CLI::App& command, double& gib, const std::string& description);

/// In bytes.
std::uint64_t bytes_of_gib(double gib);

}  // namespace isomatch::cli
