// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/maps/correspondence.h"

#include <iterator>

namespace isomatch {

Correspondence to_correspondence(const VertexMap& source_to_target) {
  Correspondence matches;
  for (int s = 0; s < std::ssize(source_to_target); ++s) {
    if (source_to_target[s] != kUnmatched) matches.push_back({s, source_to_target[s]});
  }
  return matches;
}

}  // namespace isomatch
