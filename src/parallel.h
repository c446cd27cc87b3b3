// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>

#include "isomatch/context.h"

namespace isomatch {

/// Of what the pieces of a loop threw the exception of the first piece, so that the same failure is
/// reported whatever the threads did.
class FirstFailure {
 public:
  /// Runs `work`, which belongs to piece `piece`, and keeps what it throws.
  template <class Work>
  void guard(std::ptrdiff_t piece, const Work& work) {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (exception_ && piece_ <= piece) return;
      exception_ = std::current_exception();
      piece_ = piece;
    }
  }

  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr exception_;
  std::ptrdiff_t piece_ = 0;
};

/// Calls `body(state, i)` for each i in [0, count) on `context.threads` threads, each with a state
/// of its own that `make()` returns. The only door to OpenMP: an exception that left one of its
/// regions would end the program. What `make` or `body` throws is thrown again, the exception of
/// the lowest piece of the loop; throws `Cancelled`, with pieces left out, after a stop.
template <class Make, class Body>
void parallel_for(std::ptrdiff_t count, const Context& context, const Make& make,
                  const Body& body) {
  // Pieces small enough to share out evenly and to see a stop soon, large enough to cost nothing.
  constexpr std::ptrdiff_t kPiecesAThread = 16, kLargestPiece = 1024;
  const int most = std::max(1, context.threads);
  const std::ptrdiff_t size =
      std::clamp<std::ptrdiff_t>(count / (kPiecesAThread * most), 1, kLargestPiece);
  const std::ptrdiff_t pieces = (count + size - 1) / size;
  const int threads = static_cast<int>(std::clamp<std::ptrdiff_t>(pieces, 1, most));
  FirstFailure failure;
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    std::optional<decltype(make())> state;
    failure.guard(0, [&] { state.emplace(make()); });
#pragma omp for schedule(dynamic)
    for (std::ptrdiff_t piece = 0; piece < pieces; ++piece) {
      if (!state || context.stop.stop_requested()) continue;
      failure.guard(piece, [&] {
        for (std::ptrdiff_t i = piece * size; i < std::min(count, (piece + 1) * size); ++i)
          body(*state, i);
      });
    }
  }
  failure.rethrow();
  context.check_stop();
}

/// The same without a state: `body(i)`.
template <class Body>
void parallel_for(std::ptrdiff_t count, const Context& context, const Body& body) {
  struct None {};
  parallel_for(
      count, context, [] { return None(); }, [&](None&, std::ptrdiff_t i) { body(i); });
}

}  // namespace isomatch
