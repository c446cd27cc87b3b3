// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <thread>

namespace isomatch::test {
namespace {

/// Both ends of a pipe or, as far as the writer can tell, a terminal.
struct Channel {
  int reader = -1;
  int writer = -1;
};

Channel open_channel(bool terminal) {
  std::array<int, 2> ends{};
  const int failed = terminal ? openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr)
                              : pipe2(ends.data(), O_CLOEXEC);
  if (failed != 0) throw std::runtime_error("cannot open a pipe");
  return {ends[0], ends[1]};
}

[[noreturn]] void become_program(const std::string& program, std::vector<std::string> arguments,
                                 int out, int err) {
  arguments.insert(arguments.begin(), program);
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  execv(program.c_str(), argv.data());
  _exit(127);
}

/// Moves what there is to read into `text`; false at the end.
bool drain(int reader, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = read(reader, buffer.data(), buffer.size());
  if (count <= 0) return false;
  text.append(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

/// Reads both to their ends at once, so that neither pipe fills up while the other is waited for.
void read_all(int out, int err, Outcome& outcome) {
  std::array<pollfd, 2> sources{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  while (sources[0].fd >= 0 || sources[1].fd >= 0) {
    poll(sources.data(), sources.size(), -1);
    if (sources[0].revents != 0 && !drain(out, outcome.output)) sources[0].fd = -1;
    if (sources[1].revents != 0 && !drain(err, outcome.errors)) sources[1].fd = -1;
  }
}

int wait_for_exit(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

Outcome run(const std::vector<std::string>& arguments, const RunOptions& options) {
  const Channel out = open_channel(options.all_on_terminal), err = open_channel(options.terminal);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0)
    become_program(options.program, arguments, out.writer,
                   options.all_on_terminal ? out.writer : err.writer);
  close(out.writer);
  close(err.writer);
  if (options.interrupt_after) {
    std::this_thread::sleep_for(*options.interrupt_after);
    kill(child, options.signal);
  }
  Outcome outcome;
  read_all(out.reader, err.reader, outcome);
  outcome.exit_code = wait_for_exit(child);
  close(out.reader);
  close(err.reader);
  return outcome;
}

}  // namespace isomatch::test
