// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "isomatch/context.h"
#include "isomatch/methods/tracked.h"
#include "results/batch/batch_folder.h"
#include "results/batch/pair_list.h"
#include "results/batch/result_store.h"
#include "results/json.h"

namespace isomatch::results {

/// What the pairs of a batch have in common.
struct BatchOptions {
  TrackedOptions matching;
  bool target_to_source = false;
  /// Of shapes that are kept for other pairs, about, in bytes.
  std::uint64_t memory = 0;
  /// A folder of truth to measure the maps against, see `truth_files`, or empty.
  std::string truth;
  /// The command line, for the reports.
  std::vector<std::string> words;
};

/// What a report tells of a pair in short.
struct PairSummary {
  std::string grade;
  /// Why the fit is not good, and what is odd about the shapes.
  std::string reasons, warnings;
  int matched_vertices = 0, unmatched_vertices = 0;
  double stretch = 0, unreached = 0, ambiguity = 0, seconds = 0;
  /// Of the process, at the end of the pair.
  double peak_memory_mib = 0;
  /// Of source vertices that have a counterpart, if there are any.
  std::optional<double> mean_confidence;
  /// Relative to sqrt(area) of the target, if the truth was known.
  std::optional<double> point_error;
  bool mirrored = false;
};

/// What became of a pair: a map, or else why there is none.
struct PairOutcome {
  ListedPair pair;
  PairSummary summary;
  std::string error;
  /// Whether it was finished by an earlier run, or by another process.
  bool earlier = false;

  bool matched() const { return error.empty(); }
};

/// The options as they go into reports.
Json batch_options_json(const BatchOptions& options);

/// Matches the pairs, each on one thread, as many at a time as there are threads, and leaves the
/// results of each, see `write_tracked`, in `store`. A shape is read and prepared
/// once, as long as memory lasts. What is wrong with a file fails its pairs and no other. Pairs
/// that are finished are passed over. `tell` is called from the calling thread, once for each pair,
/// as they end; the result has them in the order of the list. Throws `Cancelled` after a stop: then
/// pairs that are not finished have left nothing.
std::vector<PairOutcome> match_pairs(const std::vector<ListedPair>& pairs,
                                     const BatchFolder& folder, ResultStore& store,
                                     const BatchOptions& options,
                                     const std::function<void(const PairOutcome&)>& tell,
                                     const Context& context);

/// The outcomes of pairs that are finished; the others have not been matched yet.
std::vector<PairOutcome> finished_pairs(const std::vector<ListedPair>& pairs,
                                        const BatchFolder& folder);

/// Writes a CSV table with a line for each pair: names, whether it was matched, the fit and its
/// measures, what makes it doubtful, what is odd about the shapes, what it took, and the error.
/// Throws `BadFile`.
void write_pair_table(const std::string& path, const std::vector<PairOutcome>& outcomes);

}  // namespace isomatch::results
