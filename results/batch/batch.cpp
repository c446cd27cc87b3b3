// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <optional>
#include <thread>
#include <utility>

#include "isomatch/error.h"
#include "results/batch/shape_store.h"
#include "results/folder/report.h"
#include "results/folder/tracked_output.h"
#include "results/folder/verdict.h"
#include "results/option_names.h"

namespace isomatch::results {
namespace {

/// Outcomes on their way from the threads that match to the one that tells of them.
class Outcomes {
 public:
  void put(std::size_t place, PairOutcome outcome) {
    const std::scoped_lock lock(mutex_);
    waiting_.emplace_back(place, std::move(outcome));
    arrived_.notify_one();
  }

  /// Waits for the next one; none if a thread has given up.
  std::optional<std::pair<std::size_t, PairOutcome>> take() {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, [&] { return !waiting_.empty() || failure_; });
    if (waiting_.empty()) return std::nullopt;
    auto next = std::move(waiting_.front());
    waiting_.pop_front();
    return next;
  }

  void give_up(std::exception_ptr failure) {
    const std::scoped_lock lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
    arrived_.notify_one();
  }

  void rethrow_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<std::pair<std::size_t, PairOutcome>> waiting_;
  std::exception_ptr failure_;
};

class Batch {
 public:
  Batch(const std::vector<ListedPair>& pairs, const BatchFolder& folder,
        const BatchOptions& options, const Context& context)
      : pairs_(pairs),
        folder_(folder),
        options_(options),
        stop_(context.stop),
        store_(options.memory) {}

  void work() {
    try {
      for (std::size_t place = next_++; place < pairs_.size(); place = next_++)
        outcomes_.put(place, outcome(pairs_[place]));
    } catch (...) {
      next_ = pairs_.size();
      outcomes_.give_up(std::current_exception());
    }
  }

  Outcomes& outcomes() { return outcomes_; }

 private:
  PairOutcome outcome(const ListedPair& pair) {
    if (std::optional<Json> report = folder_.report_of(pair.name))
      return {pair, std::move(*report), "", true};
    const std::string place = folder_.begin(pair.name);
    try {
      PairOutcome outcome{pair, matched(pair, place), "", false};
      folder_.finish(pair.name);
      return outcome;
    } catch (const Cancelled&) {
      folder_.abandon(pair.name);
      throw;
    } catch (const std::bad_alloc&) {
      folder_.abandon(pair.name);
      return {pair, {}, "out of memory", false};
    } catch (const std::exception& error) {
      folder_.abandon(pair.name);
      return {pair, {}, error.what(), false};
    }
  }

  /// Matches a pair, writes the results into `place` and returns the report.
  Json matched(const ListedPair& pair, const std::string& place) {
    const Context alone{.threads = 1, .progress = {}, .stop = stop_};
    alone.check_stop();
    TrackedRun run{{options_.words,
                    std::filesystem::current_path().string(),
                    store_.get(pair.source),
                    store_.get(pair.target),
                    {}},
                   batch_options_json(options_)};
    run.target_to_source = options_.target_to_source;
    run.result =
        match_tracked(run.inputs.source.shape, run.inputs.target.shape, options_.matching, alone);
    run.fits = fits_of(run.inputs, run.result, alone);
    return write_tracked(
        {place, tracked_files(options_.matching.alternatives, options_.target_to_source),
         InputFiles({pair.source, pair.target})},
        run);
  }

  const std::vector<ListedPair>& pairs_;
  const BatchFolder& folder_;
  const BatchOptions& options_;
  std::stop_token stop_;
  ShapeStore store_;
  std::atomic<std::size_t> next_ = 0;
  Outcomes outcomes_;
};

}  // namespace

Json batch_options_json(const BatchOptions& options) {
  Json json = options_json("tracked");
  add_options(json, options.matching);
  json["landmarks"] = Json();
  json["target-to-source"] = options.target_to_source;
  return json;
}

std::vector<PairOutcome> match_pairs(const std::vector<ListedPair>& pairs,
                                     const BatchFolder& folder, const BatchOptions& options,
                                     const std::function<void(const PairOutcome&)>& tell,
                                     const Context& context) {
  std::vector<PairOutcome> outcomes(pairs.size());
  Batch batch(pairs, folder, options, context);
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < std::max(1, context.threads); ++k)
      threads.emplace_back([&] { batch.work(); });
    for (std::size_t done = 0; done < pairs.size();) {
      auto next = batch.outcomes().take();
      if (!next) break;
      tell(next->second);
      outcomes[next->first] = std::move(next->second);
      ++done;
      if (context.progress)
        context.progress(static_cast<double>(done) / static_cast<double>(pairs.size()),
                         fmt::format("{} of {} pairs", done, pairs.size()));
    }
  }
  batch.outcomes().rethrow_failure();
  return outcomes;
}

std::vector<PairOutcome> finished_pairs(const std::vector<ListedPair>& pairs,
                                        const BatchFolder& folder) {
  std::vector<PairOutcome> outcomes;
  for (const ListedPair& pair : pairs) {
    std::optional<Json> report = folder.report_of(pair.name);
    outcomes.push_back({pair, report.value_or(Json()), report ? "" : "not matched yet", true});
  }
  return outcomes;
}

}  // namespace isomatch::results
