// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <utility>

#include "isomatch/error.h"
#include "program/interrupt.h"
#include "program/partly_failed.h"
#include "program/progress_bar.h"
#include "program/usage_error.h"

namespace isomatch::cli {
namespace {

enum ExitCode {
  kSuccess = 0,
  kInternalError = 1,
  kBadInput = 2,
  kPartlyFailed = 3,
  kSignalBase = 128
};

void flush_output() {
  if (std::fflush(stdout) != 0) throw BadFile("standard output", std::strerror(errno));
}

void run(const Request& request, const std::stop_token& stop) {
  ProgressBar bar(request.quiet);
  Context context;
  context.threads = request.threads;
  context.stop = stop;
  context.progress = [&](double fraction, std::string_view stage) { bar.update(fraction, stage); };
  request.action(context);
  flush_output();
}

int run_guarded(const std::string& name, const Request& request) {
  const InterruptGuard interrupt;
  const auto fail = [&](ExitCode code, std::string_view reason) {
    fmt::print(stderr, "{}: {}\n", name, reason);
    return code;
  };
  try {
    run(request, interrupt.token());
    return kSuccess;
  } catch (const Cancelled&) {
    fail(kInternalError, "interrupted");
    return kSignalBase + interrupt.signal();
  } catch (const PartlyFailed& error) {
    return fail(kPartlyFailed, error.what());
  } catch (const BadFile& error) {
    return fail(kBadInput, error.what());
  } catch (const InvalidInput& error) {
    return fail(kBadInput, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kInternalError, "out of memory");
  } catch (const std::exception& error) {
    return fail(kInternalError, fmt::format("internal error: {}", error.what()));
  }
}

/// Of `words` the first is the program's name.
void parse(CLI::App& app, std::vector<std::string> words) {
  // CLI11 takes them from the end.
  std::reverse(words.begin(), words.end());
  words.pop_back();
  app.parse(std::move(words));
}

}  // namespace

void restart_without_spinning(char** argv) {
  constexpr const char* kVariable = "OMP_WAIT_POLICY";
  if (std::getenv(kVariable) != nullptr || setenv(kVariable, "passive", 1) != 0) return;
  execv("/proc/self/exe", argv);
}

int run_program(CLI::App& app, Request& request, int argc, char** argv) {
  const std::string name = app.get_name();
  request.words.assign(argv, argv + argc);
  const std::vector<std::string> words = with_help_as_option(app, request.words);
  try {
    parse(app, words);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: {}\n", name, usage_error(app, words, error));
    return kBadInput;
  }
  return run_guarded(name, request);
}

}  // namespace isomatch::cli
