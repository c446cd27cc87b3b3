// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "bench/child.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <thread>

#include "isomatch/error.h"

namespace isomatch::baselines {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void be_child(const std::function<std::string()>& work, std::FILE* file) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const std::string output = work();
  std::fwrite(output.data(), 1, output.size(), file);
  std::fflush(file);
  _exit(0);
}

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string all;
  char part[4096];
  while (const std::size_t count = std::fread(part, 1, sizeof part, file)) all.append(part, count);
  return all;
}

/// Waits for the end of `child`; its status.
int wait_for(pid_t child, const std::stop_token& stop) {
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (stop.stop_requested()) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      throw Cancelled();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return status;
}

}  // namespace

ChildOutcome run_child(const std::function<std::string()>& work, const std::stop_token& stop) {
  const File file(std::tmpfile());
  if (!file) throw InternalError("there is no place for a temporary file");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw InternalError("there is no process for a method");
  if (child == 0) be_child(work, file.get());
  const int status = wait_for(child, stop);
  if (WIFSIGNALED(status)) return {WTERMSIG(status), {}};
  return {0, content(file.get())};
}

}  // namespace isomatch::baselines
