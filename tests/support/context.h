// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "isomatch/context.h"

namespace isomatch::test {

/// A context of this many threads and nothing else.
inline Context with_threads(int threads) {
  Context context;
  context.threads = threads;
  return context;
}

}  // namespace isomatch::test
