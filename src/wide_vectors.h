// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <cstdlib>

/// Before a function with a plain loop over arrays: the function is compiled for vectors of 256
/// bits as well, and where the processor has them, that one is called. Results are the same bytes,
/// since nothing is contracted and no sum is reordered. Not beside sanitizers, which start later
/// than the choice is made, nor where the linker cannot choose, nor with Clang, where no one has
/// measured it.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define ISOMATCH_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define ISOMATCH_WIDE_VECTORS
#endif
