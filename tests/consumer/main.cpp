// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors

// What any consumer does: includes public headers, links, and gets a right answer.
#include <isomatch/error.h>
#include <isomatch/mesh/synth.h>
#include <isomatch/methods/paper.h>
#include <isomatch/version.h>

#include <algorithm>
#include <iostream>
#include <string_view>
#include <vector>

namespace {

/// Whether the extremities of a shape matched to itself stay where they are. The coarsest level
/// alone, since this is built without optimisation.
bool matches_itself(const isomatch::Mesh& mesh) {
  const isomatch::Shape shape(mesh);
  isomatch::PaperOptions options;
  options.coarse_candidates = 1;
  options.max_levels = 0;
  const isomatch::PaperResult result = isomatch::match_paper(shape, shape, options);
  const std::vector<int>& bases = result.source_bases;
  std::cout << bases.size() << " extremities\n";
  return bases.size() >= 3 &&
         std::ranges::all_of(bases, [&](int v) { return result.source_to_target[v] == v; });
}

bool throws_its_exceptions() {
  try {
    const isomatch::Shape shape{isomatch::Mesh{}};
  } catch (const isomatch::InvalidInput&) {
    return true;
  }
  return false;
}

}  // namespace

int main() {
  if (isomatch::kVersion != std::string_view(EXPECTED_VERSION) || !throws_its_exceptions())
    return 1;
  const isomatch::Mesh mesh = isomatch::synthesize({.vertices = 1000, .pose = 1}).mesh;
  return matches_itself(mesh) ? 0 : 1;
}
