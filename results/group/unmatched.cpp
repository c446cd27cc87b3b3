// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/group/unmatched.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "isomatch/error.h"
#include "isomatch/mesh/topology.h"

namespace isomatch::results {
namespace {

/// Why a member cannot be used; empty if it can.
std::string fault_of(const GroupMember& member) {
  constexpr int kFewestPoints = 3;
  if (!member.is_matched()) return "none of its maps agrees with those of other shapes";
  const auto missing = std::ranges::count(member.from_template, kNoFace, &SurfacePoint::face);
  if (std::ssize(member.from_template) - missing < kFewestPoints)
    return "fewer than three of the template's vertices lie on it";
  return {};
}

template <class T>
void keep(std::vector<T>& all, const std::vector<int>& kept) {
  std::vector<T> result;
  result.reserve(kept.size());
  for (const int k : kept) result.push_back(std::move(all[k]));
  all = std::move(result);
}

/// Pairs of shapes that are kept, by their new places.
void keep_pairs(std::vector<GroupPair>& pairs, const std::vector<int>& place) {
  std::erase_if(pairs,
                [&](const auto& pair) { return place[pair.source] < 0 || place[pair.target] < 0; });
  for (GroupPair& pair : pairs) {
    pair.source = place[pair.source];
    pair.target = place[pair.target];
  }
}

}  // namespace

void leave_out_unmatched(GroupRun& run) {
  Collection& collection = run.collection;
  std::vector<int> kept, place(collection.names.size(), -1);
  for (std::size_t k = 0; k < place.size(); ++k) {
    const std::string fault = fault_of(run.result.members[k]);
    if (fault.empty()) {
      place[k] = static_cast<int>(kept.size());
      kept.push_back(static_cast<int>(k));
    } else {
      collection.left_out.push_back({collection.paths[k], collection.paths[k] + ": " + fault});
    }
  }
  if (kept.size() < 2)
    throw InvalidInput("none of the shapes could be matched with the template " +
                       collection.names[run.result.template_shape]);
  keep(collection.paths, kept);
  keep(collection.names, kept);
  keep(collection.shapes, kept);
  keep(run.result.members, kept);
  keep_pairs(run.result.pairs, place);
  run.result.template_shape = place[run.result.template_shape];
}

}  // namespace isomatch::results
