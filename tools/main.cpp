// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "command.h"
#include "interrupt.h"
#include "isomatch/error.h"
#include "isomatch/version.h"
#include "progress_bar.h"

namespace isomatch::cli {
namespace {

enum ExitCode { kSuccess = 0, kInternalError = 1, kBadInput = 2, kSignalBase = 128 };

int fail(ExitCode code, std::string_view reason) {
  fmt::print(stderr, "isomatch: {}\n", reason);
  return code;
}

void describe_program(CLI::App& app, Request& request) {
  app.set_version_flag("--version", fmt::format("isomatch {}", kVersion));
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  add_match(app, request);
  add_eval(app, request);
  add_info(app, request);
  add_synth(app, request);
  add_render(app, request);
  set_example(app, "isomatch match cat0.off cat1.off -o cats");
}

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

/// Runs the chosen subcommand and turns what it throws into one line and an exit code.
int run_guarded(const Request& request) {
  const InterruptGuard interrupt;
  try {
    run(request, interrupt.token());
    return kSuccess;
  } catch (const Cancelled&) {
    fail(kInternalError, "interrupted");
    return kSignalBase + interrupt.signal();
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

int main_guarded(int argc, char** argv) {
  Request request;
  request.words.assign(argv, argv + argc);
  CLI::App app("Dense correspondence between two triangle meshes of the same thing.", "isomatch");
  describe_program(app, request);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    return fail(kBadInput, fmt::format("{} (see isomatch --help)", error.what()));
  }
  return run_guarded(request);
}

/// Lets idle threads sleep instead of spin, unless the user decided otherwise. Where other programs
/// keep the cores busy, spinning made a match four to ten times slower; where they do not, it gains
/// nothing measurable. OpenMP reads the setting when it is loaded, before `main`, so the program
/// starts itself once more.
void restart_without_spinning(char** argv) {
  constexpr const char* kVariable = "OMP_WAIT_POLICY";
  if (std::getenv(kVariable) != nullptr || setenv(kVariable, "passive", 1) != 0) return;
  execv("/proc/self/exe", argv);
}

}  // namespace
}  // namespace isomatch::cli

int main(int argc, char** argv) {
  isomatch::cli::restart_without_spinning(argv);
  return isomatch::cli::main_guarded(argc, argv);
}
