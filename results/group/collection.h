// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/shape/shape.h"
#include "results/warn.h"

namespace isomatch::results {

/// A shape that could not be used, and why.
struct LeftOut {
  std::string path, reason;
};

/// Shapes from files. Their names are those of the files without endings.
struct Collection {
  std::vector<std::string> paths, names;
  std::vector<Shape> shapes;
  std::vector<LeftOut> left_out;
};

/// The name of a file without folders and ending.
std::string shape_name(const std::string& path);

/// The files among `places` and the meshes in the folders among them, in that order,
/// without those that isomatch left in these folders. Throws
/// `BadFile` if one is not there, `InvalidInput` if two have the same name without the ending.
std::vector<std::string> collected_files(const std::vector<std::string>& places);

/// Reads the files; what is wrong with one leaves it out. What readers warn of goes to `warn`.
Collection read_collection(const std::vector<std::string>& files, const Warn& warn,
                           const Context& context);

}  // namespace isomatch::results
