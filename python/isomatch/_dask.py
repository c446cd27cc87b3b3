# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Shares of a batch on the workers of Dask."""

from ._batch_run import run

#: Shares for each thread of a worker: few enough that neighbours share shapes, enough that no
#: worker waits long for the last one.
_SHARES_A_THREAD = 4


def _count_of(client, pairs, shards):
    if shards is None:
        shards = _SHARES_A_THREAD * max(1, sum(client.nthreads().values()))
    elif isinstance(shards, bool) or not isinstance(shards, int):
        raise TypeError(f"shards: expected a whole number, not {shards!r}")
    if shards < 1:
        raise ValueError("shards: expected at least 1")
    return min(shards, pairs)


class _Unwanted(Exception):
    pass


def _run_share(job, share, count):
    """A task. Dask does not interrupt tasks that are cancelled, so they look themselves."""
    from distributed import get_worker

    worker = get_worker()
    key = worker.get_current_task()

    def watch(_):
        task = worker.state.tasks.get(key)
        if task is None or task.state == "cancelled":
            raise _Unwanted

    run(job, "--shard", f"{share}/{count}", watch=watch)


def run_shares(client, job, pairs, shards, retries, progress):
    """Each share is a task. Those that fail, or whose workers died more often than Dask itself
    allows, are submitted again, `retries` times each; bad input is not."""
    from distributed import as_completed

    count = _count_of(client, pairs, shards)
    left = {share: retries for share in range(1, count + 1)}

    def submit(share):
        return client.submit(_run_share, job, share, count, pure=False)

    shares = {submit(share): share for share in left}
    running = as_completed(list(shares))
    done = 0
    try:
        for future in running:
            share = shares.pop(future)
            error = future.exception()
            if error is None:
                done += 1
                if progress:
                    progress(done / count, f"{done} of {count} shares")
            elif isinstance(error, (ValueError, OSError, TypeError)) or left[share] <= 0:
                raise error
            else:
                left[share] -= 1
                again = submit(share)
                shares[again] = share
                running.add(again)
    finally:
        client.cancel(list(shares))
