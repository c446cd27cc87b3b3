// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "isomatch/shape/diagnosis.h"

namespace isomatch::results {

/// Keeps the order in which fields were added.
using Json = nlohmann::ordered_json;

/// Names of files are bytes, but JSON is UTF-8. `object[key]` becomes `path`, with U+FFFD for what
/// is not UTF-8. Then, and only then, `object[key + "_escaped"]` becomes the same with % and what
/// is not ASCII escaped as in an address: K%F6rper.off.
void set_path(Json& object, const std::string& key, const std::string& path);
/// The same of a list; where one name needs it, all are escaped.
void set_paths(Json& object, const std::string& key, const std::vector<std::string>& paths);

/// What `set_path` and `set_paths` set. Throws `Json::exception` where there is no such thing.
std::string get_path(const Json& object, const std::string& key);
std::vector<std::string> get_paths(const Json& object, const std::string& key);

/// All of a diagnosis; the fields have the names of the struct's. No genus is null.
Json to_json(const MeshDiagnosis& diagnosis);

}  // namespace isomatch::results
