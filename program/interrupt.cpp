// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "program/interrupt.h"

#include <csignal>

namespace isomatch::cli {
namespace {

sigset_t handled_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

void die_by(int signal) {
  std::signal(signal, SIG_DFL);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  std::raise(signal);
}

}  // namespace

// Requesting a stop runs callbacks and takes a lock, which a signal handler must not do. Hence a
// thread that waits for the signals instead of a handler.
InterruptGuard::InterruptGuard() {
  const sigset_t set = handled_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  watcher_ = std::jthread([this](const std::stop_token& closing) { wait_for_signals(closing); });
}

InterruptGuard::~InterruptGuard() {
  watcher_.request_stop();
  pthread_kill(watcher_.native_handle(), SIGTERM);
}

void InterruptGuard::wait_for_signals(const std::stop_token& closing) {
  const sigset_t set = handled_signals();
  while (true) {
    int signal = 0;
    sigwait(&set, &signal);
    if (closing.stop_requested()) return;
    if (stop_.stop_requested()) die_by(signal);
    signal_ = signal;
    stop_.request_stop();
  }
}

}  // namespace isomatch::cli
