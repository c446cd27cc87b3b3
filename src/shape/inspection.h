// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <optional>

#include "isomatch/shape/diagnosis.h"
#include "shape/extraction.h"

namespace isomatch {

/// A mesh's diagnosis and its surface, none if no face has an area.
struct Inspection {
  MeshDiagnosis diagnosis;
  std::optional<ExtractedSurface> surface;
};

/// Diagnoses `mesh` and does what `extract_surface` does, in little more time. Throws
/// `InvalidInput` if `mesh` fails `validate`. O(N log N).
Inspection inspect(const Mesh& mesh);

}  // namespace isomatch
