// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <stdexcept>
#include <string>

namespace isomatch {

/// Arguments, options or mesh contents that break a documented precondition.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A file that cannot be read or written. The message is one line that names the file, the place in
/// it (line or byte, where there is one) and the reason.
class BadFile : public std::runtime_error {
 public:
  BadFile(const std::string& path, const std::string& reason)
      : std::runtime_error(path + ": " + reason) {}
  BadFile(const std::string& path, const std::string& place, const std::string& reason)
      : std::runtime_error(path + ": " + place + ": " + reason) {}
};

/// A numerical stage that could not finish on valid input.
class SolverFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller asked for the work to stop through `Context::stop`.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// A broken invariant of this library: a bug worth reporting.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace isomatch
