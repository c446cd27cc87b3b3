// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/group/group.h"
#include "results/folder/result_folder.h"
#include "results/group/collection.h"
#include "results/group/group_output.h"
#include "results/json.h"

namespace isomatch::results {

/// A collection that was matched.
struct GroupRun {
  /// The command line and the folder in which it was run.
  std::vector<std::string> words;
  std::string working_folder;
  Json options;
  Collection collection;
  GroupResult result;
  /// Whether the maps between all shapes are written too.
  bool all_maps = false;

  const Mesh& template_mesh() const { return collection.shapes[result.template_shape].mesh(); }
};

/// Of the pairs of each shape, the mean of their cycle errors.
std::vector<double> cycle_errors(const GroupRun& run);

/// Where these vertices of the template lie on all shapes, see `GroupMember::registered`: closer to
/// their surfaces than maps err. The nearest points of the surfaces would fold every thirtieth
/// triangle between them.
CorrespondingPoints points_of(const GroupRun& run, const std::vector<int>& template_vertices);

/// `count` vertices of the template, evenly spread over it; all if it is zero, or as many as there
/// are. Throws `Cancelled`.
std::vector<int> spread_vertices(const GroupRun& run, int count, const Context& context);

/// The names of what `write_group_run` may write, but for report.json. Throws `InvalidInput` if
/// two of them are the same, as of the pairs of a and b__c, and of a__b and c.
std::vector<std::string> group_run_files(const std::vector<std::string>& names, bool all_maps);

/// Writes what `write_group` does and, in the numbers of the files,
/// - maps/NAME.from_template.bary.txt: for each vertex of the template a face of the shape and the
///   weights of its corners; and maps/NAME.to_template.bary.txt, the other way round;
/// - if they are wanted, maps/A__B.bary.txt: the same from each shape to each other one;
/// - pairs.csv: the pairs that were matched, their cost, their cycle error and what became of them;
/// - report.json, which is returned: options, shapes with their fits, those that were left out,
///   times.
/// Throws `BadFile`, `InvalidInput`.
Json write_group_run(const ResultPlan& plan, const GroupRun& run, const GroupOutput& output);

}  // namespace isomatch::results
