// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/batch/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "isomatch/error.h"
#include "match/tracked_options.h"
#include "memory_option.h"
#include "program/partly_failed.h"
#include "program/say.h"
#include "results/batch/pair_list.h"
#include "results/batch/result_store.h"
#include "results/batch/shares.h"
#include "results/batch/truth_folder.h"
#include "results/files/input_files.h"

namespace isomatch::cli {
namespace {

struct BatchCommand {
  std::string list, all, chain, folder;
  std::vector<std::string> star;
  /// Share and number of shares, or empty.
  std::string shard;
  bool resume = false, merge = false, packed = false;
  double memory_gib = 1;
  results::BatchOptions options;
};

/// I/N.
struct Shard {
  int share = 1, count = 1;
};

Shard shard_of(const std::string& text) {
  Shard shard;
  if (text.empty()) return shard;
  const char* const end = text.data() + text.size();
  const auto share = std::from_chars(text.data(), end, shard.share);
  const auto count = share.ptr < end && *share.ptr == '/'
                         ? std::from_chars(share.ptr + 1, end, shard.count)
                         : std::from_chars_result{text.data(), std::errc::invalid_argument};
  if (share.ec != std::errc() || count.ec != std::errc() || count.ptr != end || shard.share < 1 ||
      shard.share > shard.count)
    throw InvalidInput(
        fmt::format("--shard: expected I/N with I from 1 to N, such as 2/8, not {}", text));
  return shard;
}

std::vector<results::ListedPair> pairs_of(const BatchCommand& batch) {
  if (!batch.all.empty()) return results::all_pairs(batch.all);
  if (!batch.chain.empty()) return results::chain_of_pairs(batch.chain);
  if (!batch.star.empty()) return results::star_of_pairs(batch.star[0], batch.star[1]);
  return results::read_pairs(batch.list);
}

/// A line of the log.
std::string told(const results::PairOutcome& outcome) {
  if (!outcome.matched()) return fmt::format("{}: failed: {}", outcome.pair.name, outcome.error);
  return fmt::format("{}: {} fit{}", outcome.pair.name, outcome.summary.grade,
                     outcome.earlier ? " (earlier)" : "");
}

/// Appends to the log of the batch, each line as it happens.
class Log {
 public:
  Log(const std::string& path, bool quiet) : file_(std::fopen(path.c_str(), "ae")), quiet_(quiet) {
    if (!file_) throw BadFile(path, "cannot be written");
  }

  void operator()(const results::PairOutcome& outcome) const {
    const std::string line = told(outcome);
    fmt::print(file_.get(), "{}\n", line);
    std::fflush(file_.get());
    if (!quiet_) say("{}", line);
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  bool quiet_;
};

void finish(const results::BatchFolder& folder, const std::string& table,
            const std::vector<results::PairOutcome>& outcomes, bool quiet) {
  results::write_pair_table(folder.path_of(table), outcomes);
  const auto failed = std::ranges::count_if(
      outcomes, [](const results::PairOutcome& outcome) { return !outcome.matched(); });
  if (!quiet)
    say("{} of {} pairs matched, see {}", outcomes.size() - failed, outcomes.size(),
        folder.path_of(table));
  if (failed > 0)
    throw PartlyFailed(fmt::format("{} of {} pairs failed, see {}", failed, outcomes.size(),
                                   folder.path_of(table)));
}

void refuse_list_as_output(const BatchCommand& batch, const std::vector<std::string>& names) {
  const results::InputFiles list({batch.list});
  for (const std::string& name : names)
    list.refuse((std::filesystem::path(batch.folder) / name).string());
}

void run_batch(const BatchCommand& batch, bool quiet, const Context& context) {
  results::BatchOptions options = batch.options;
  options.matching.validate();
  options.memory = bytes_of_gib(batch.memory_gib);
  const Shard shard = shard_of(batch.shard);
  const std::vector<results::ListedPair> all = pairs_of(batch);
  const results::Json common = results::batch_options_json(options);
  if (batch.merge) {
    refuse_list_as_output(batch, {"pairs.csv"});
    const results::BatchFolder folder(batch.folder, common);
    return finish(folder, "pairs.csv", results::finished_pairs(all, folder), quiet);
  }
  results::check_truth(options.truth, all);
  const std::string suffix =
      batch.shard.empty() ? "" : fmt::format("-{}-of-{}", shard.share, shard.count);
  const std::string table = "pairs" + suffix + ".csv", log_name = "batch" + suffix + ".log";
  const std::string archive = "results" + suffix + ".sqlar";
  std::vector<std::string> files{table, log_name};
  if (batch.packed) files.push_back(archive);
  refuse_list_as_output(batch, files);
  const auto folder = results::BatchFolder::begun(batch.folder, common, files,
                                                  batch.resume || !batch.shard.empty());
  const auto store = batch.packed ? results::archive_store(folder.path_of(archive))
                                  : results::folder_store(batch.folder);
  const Log log(folder.path_of(log_name), quiet);
  finish(folder, table,
         results::match_pairs(results::share_of(all, shard.share, shard.count), folder, *store,
                              options, std::cref(log), context),
         quiet);
}

void add_pair_options(CLI::App& command, BatchCommand& batch) {
  CLI::Option_group& pairs = *command.add_option_group("Pairs, one of");
  pairs.add_option("PAIRS", batch.list,
                   "Text or CSV file with a pair a line: source, target and, if wanted, a name");
  pairs.add_option("--all", batch.all, "Every ordered pair of the meshes in this folder")
      ->type_name("FOLDER");
  pairs
      .add_option("--star", batch.star,
                  "A template onto each of the meshes in a folder: TEMPLATE FOLDER")
      ->type_name("PATH")
      ->expected(2);
  pairs.add_option("--chain", batch.chain, "Each mesh in this folder onto the next, by names")
      ->type_name("FOLDER");
  pairs.require_option(1);
}

}  // namespace

void add_batch(CLI::App& app, Request& request) {
  const auto batch = std::make_shared<BatchCommand>();
  CLI::App& command =
      *app.add_subcommand("batch", "Match many pairs; each shape is read and prepared once");
  add_pair_options(command, *batch);
  command
      .add_option("-o,--output", batch->folder,
                  "Folder for the results: a folder a pair, or an archive; pairs.csv and batch.log")
      ->type_name("DIR")
      ->required();
  command.add_flag("--resume", batch->resume,
                   "Go on with a batch that was stopped: finished pairs stay as they are");
  command
      .add_option("--shard", batch->shard,
                  "Match one of N shares of the pairs only, which may run at the same time; "
                  "implies --resume")
      ->type_name("I/N");
  command.add_flag("--packed", batch->packed,
                   "All results in one file, results.sqlar or that of a share, instead of a folder "
                   "a pair; `sqlite3 -A` extracts them");
  command.add_flag("--merge", batch->merge, "Match nothing, write pairs.csv of what is finished")
      ->excludes("--shard");
  add_memory_option(command, batch->memory_gib, "For shapes that are kept for other pairs, in GiB");
  command
      .add_option("--truth", batch->options.truth,
                  "Folder with ground truth, NAME.vts for each shape NAME; measures each map that "
                  "is made now against it, for pairs.csv")
      ->type_name("FOLDER");
  constexpr const char* kEveryMatch = "Options of every match";
  add_tracked_options(command, kEveryMatch, batch->options.matching);
  add_map_options(command, kEveryMatch, batch->options.matching, batch->options.target_to_source);
  add_run_options(command, request);
  set_example(command,
              "isomatch batch --all scans -o matched\n"
              "  isomatch batch pairs.csv -o matched --resume",
              "batch.md");
  command.callback([batch, &request] {
    batch->options.words = request.words;
    request.action = [batch, &request](const Context& context) {
      run_batch(*batch, request.quiet, context);
    };
  });
}

}  // namespace isomatch::cli
