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
#include "results/batch/shares.h"
#include "results/batch/truth_folder.h"
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

std::string all_of(const Json& sentences, const std::string& before = "") {
  std::string all;
  for (const Json& sentence : sentences)
    all += (all.empty() ? "" : "; ") + before + sentence.get<std::string>();
  return all;
}

/// None where the report has none.
std::optional<double> figure(const Json& report, const char* name) {
  const Json value = report.value(name, Json());
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

PairSummary summary_of(const Json& report) {
  const Json& fit = report.at("fit");
  PairSummary summary;
  summary.grade = fit.at("grade").get<std::string>();
  summary.reasons = all_of(fit.at("reasons"));
  for (const char* side : {"source", "target"}) {
    const std::string warnings =
        all_of(report.at(side).value("warnings", Json::array()), std::string(side) + ": ");
    summary.warnings += (summary.warnings.empty() || warnings.empty() ? "" : "; ") + warnings;
  }
  summary.matched_vertices = report.at("source_vertices_matched").get<int>();
  summary.unmatched_vertices = report.at("source_vertices_unmatched").get<int>();
  summary.stretch = fit.at("stretch").get<double>();
  summary.unreached = fit.at("unreached").get<double>();
  summary.ambiguity = report.at("ambiguity").get<double>();
  summary.mean_confidence = figure(report, "mean_confidence");
  summary.point_error = figure(report, "point_error_over_sqrt_area");
  summary.peak_memory_mib = report.at("peak_memory_mib").get<double>();
  summary.mirrored = report.at("map").at("mirrored").get<bool>();
  for (const Json& stage : report.at("seconds")) summary.seconds += stage.get<double>();
  return summary;
}

class Batch {
 public:
  Batch(const std::vector<ListedPair>& pairs, const BatchFolder& folder, ResultStore& store,
        const BatchOptions& options, const Context& context)
      : pairs_(pairs),
        order_(order_of_work(pairs)),
        folder_(folder),
        store_(store),
        options_(options),
        stop_(context.stop),
        shapes_(options.memory) {}

  void work() {
    try {
      for (std::size_t k = next_++; k < order_.size(); k = next_++)
        outcomes_.put(order_[k], outcome(pairs_[order_[k]]));
    } catch (...) {
      begin_no_more();
      outcomes_.give_up(std::current_exception());
    }
  }

  /// Threads end with the pair that they are at.
  void begin_no_more() { next_ = order_.size(); }

  Outcomes& outcomes() { return outcomes_; }

 private:
  PairOutcome outcome(const ListedPair& pair) {
    PairOutcome outcome{pair, {}, "", false};
    try {
      std::optional<Json> report = folder_.report_of(pair);
      outcome.earlier = report.has_value();
      if (!report) report = matched(pair);
      outcome.summary = summary_of(*report);
    } catch (const Cancelled&) {
      store_.abandon(pair.name);
      throw;
    } catch (const std::bad_alloc&) {
      outcome.error = "out of memory";
    } catch (const std::exception& error) {
      outcome.error = error.what();
    }
    if (!outcome.matched()) store_.abandon(pair.name);
    return outcome;
  }

  /// Matches a pair, writes the results and returns the report.
  Json matched(const ListedPair& pair) {
    const Context alone{.threads = 1, .progress = {}, .stop = stop_};
    alone.check_stop();
    TrackedRun run{{options_.words,
                    std::filesystem::current_path().string(),
                    shapes_.get(pair.source),
                    shapes_.get(pair.target),
                    {}},
                   batch_options_json(options_)};
    run.target_to_source = options_.target_to_source;
    const Shape &source = run.inputs.source.shape, &target = run.inputs.target.shape;
    // Before the work, so that a bad file costs none.
    const TruthVertices truth = read_truth(truth_files(options_.truth, pair),
                                           {source.num_vertices(), target.num_vertices()});
    run.result = match_tracked(source, target, options_.matching, alone);
    run.fits = fits_of(run.inputs, run.result, alone);
    run.point_error =
        mean_point_error(source, target, truth, run.result.maps.front().source_to_target, alone);
    store_.abandon(pair.name);
    Json report =
        write_tracked({store_.place_for(pair.name),
                       tracked_files(options_.matching.alternatives, options_.target_to_source),
                       InputFiles({pair.source, pair.target})},
                      run);
    if (!store_.finish(pair.name)) return folder_.again().report_of(pair).value();
    return report;
  }

  const std::vector<ListedPair>& pairs_;
  const std::vector<std::size_t> order_;
  const BatchFolder& folder_;
  ResultStore& store_;
  const BatchOptions& options_;
  std::stop_token stop_;
  ShapeStore shapes_;
  std::atomic<std::size_t> next_ = 0;
  Outcomes outcomes_;
};

/// As they end, until all have or a thread has given up.
void tell_all(Batch& batch, std::vector<PairOutcome>& outcomes,
              const std::function<void(const PairOutcome&)>& tell, const Context& context) {
  for (std::size_t done = 0; done < outcomes.size();) {
    auto next = batch.outcomes().take();
    if (!next) return;
    tell(next->second);
    outcomes[next->first] = std::move(next->second);
    ++done;
    if (context.progress)
      context.progress(static_cast<double>(done) / static_cast<double>(outcomes.size()),
                       fmt::format("{} of {} pairs", done, outcomes.size()));
  }
}

}  // namespace

Json batch_options_json(const BatchOptions& options) {
  Json json = options_json("tracked");
  add_options(json, options.matching);
  json["landmarks"] = Json();
  json["target-to-source"] = options.target_to_source;
  return json;
}

std::vector<PairOutcome> match_pairs(const std::vector<ListedPair>& pairs,
                                     const BatchFolder& folder, ResultStore& store,
                                     const BatchOptions& options,
                                     const std::function<void(const PairOutcome&)>& tell,
                                     const Context& context) {
  std::vector<PairOutcome> outcomes(pairs.size());
  Batch batch(pairs, folder, store, options, context);
  {
    std::vector<std::jthread> threads;
    try {
      const auto most =
          std::min(pairs.size(), static_cast<std::size_t>(std::max(1, context.threads)));
      for (std::size_t k = 0; k < most; ++k) threads.emplace_back([&] { batch.work(); });
      tell_all(batch, outcomes, tell, context);
    } catch (...) {
      batch.begin_no_more();
      throw;
    }
  }
  batch.outcomes().rethrow_failure();
  return outcomes;
}

std::vector<PairOutcome> finished_pairs(const std::vector<ListedPair>& pairs,
                                        const BatchFolder& folder) {
  std::vector<PairOutcome> outcomes;
  for (const ListedPair& pair : pairs) {
    PairOutcome outcome{pair, {}, "", true};
    try {
      const std::optional<Json> report = folder.report_of(pair);
      if (report)
        outcome.summary = summary_of(*report);
      else
        outcome.error = "not matched yet";
    } catch (const std::exception& error) {
      outcome.error = error.what();
    }
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace isomatch::results
