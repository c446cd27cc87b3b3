// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <nlohmann/json.hpp>

#include "isomatch/diagnosis.h"

namespace isomatch::cli {

/// Keeps the order in which fields were added.
using Json = nlohmann::ordered_json;

/// All of a diagnosis; the fields have the names of the struct's. No genus is null.
Json to_json(const MeshDiagnosis& diagnosis);

}  // namespace isomatch::cli
