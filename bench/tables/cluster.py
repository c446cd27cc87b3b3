#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""A batch carried by Slurm and by Dask while processes are killed, as a page in
docs/results/cluster.md.

Matches all ordered pairs of some tiny shapes by one `isomatch batch`, by a job array in a Slurm of one
node (tests/cluster/slurm.sh), of which tasks are killed, and by `isomatch.batch` with two workers of
Dask, which are killed. Counts pairs that are lost, matched twice, or of other bytes.
Needs the packages of the section cluster and the Python package, see docs/python.md.
Usage: bench/tables/cluster.py [--shapes 101] [--vertices 20] [--tasks 20] [--kills 5]
"""

import argparse
import collections
import contextlib
import filecmp
import itertools
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np
from common import (ROOT, add_common_arguments, commit, machine, run, table_head, table_line,
                    write_page)

import isomatch

MAP_FILES = ("source_to_target.bary.txt", "registered.ply", "correspondence.txt")
SLURM = ROOT / "tests/cluster/slurm.sh"
CORES = os.cpu_count()


def lump(seed, rings, segments):
    """An ellipsoid with a bump."""
    generator = np.random.default_rng(seed)
    axes = [1 + 0.2 * generator.random(), 0.6 + 0.1 * generator.random(), 0.4]
    theta = np.repeat(np.pi * np.arange(1, rings) / rings, segments)
    phi = np.tile(2 * np.pi * np.arange(segments) / segments, rings - 1)
    bump = 1 + 0.25 * np.exp(-3 * ((theta - 1) ** 2 + (phi - 1) ** 2))
    sphere = [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)]
    around = np.column_stack(sphere) * axes * bump[:, None]
    vertices = np.vstack([[0, 0, axes[2]], around, [0, 0, -axes[2]]])
    ring = np.arange(segments)
    after, last = (ring + 1) % segments, len(vertices) - 1
    faces = [np.column_stack([0 * ring, 1 + ring, 1 + after]),
             np.column_stack([0 * ring + last, last - segments + after, last - segments + ring])]
    for first in range(1, last - segments, segments):
        a, b = first + ring, first + after
        c, d = a + segments, b + segments
        faces += [np.column_stack([a, c, d]), np.column_stack([a, d, b])]
    return vertices, np.vstack(faces)


def make_shapes(count, vertices, folder):
    segments = max(6, round((2 * vertices) ** 0.5))
    rings = 1 + (vertices - 2) // segments
    files = [folder / f"s{k:03}.off" for k in range(count)]
    for k, file in enumerate(files):
        isomatch.write_mesh(file, lump(k, rings, segments))
    return files


def call_slurm(folder, command):
    return run(["bash", "-c", f". {SLURM}; has_slurm; slurm_folder={folder}; {command}"])


@contextlib.contextmanager
def slurm(folder):
    os.environ["SLURM_CONF"] = str(folder / "slurm.conf")
    os.environ["SLURM_TEST_CPUS"] = str(CORES)
    try:
        call_slurm(folder, f"start_slurm {folder} {os.getpid()}")
        yield
    finally:
        call_slurm(folder, "stop_slurm")


class Killer(threading.Thread):
    """Kills a process now and then, one of those that `victims` gives."""

    def __init__(self, kills, pause, victims):
        super().__init__(daemon=True)
        self.left, self.pause, self.victims = kills, pause, victims
        self.killed = 0
        self.generator = random.Random(0)
        self.over = threading.Event()
        self.start()

    def run(self):
        while self.left > 0 and not self.over.wait(self.pause * self.generator.uniform(0.5, 1.5)):
            victims = self.victims()
            if victims:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(self.generator.choice(victims), signal.SIGKILL)
                    self.killed += 1
                    self.left -= 1

    def stop(self):
        self.over.set()
        self.join()
        return self.killed


def programs_of(pairs, out):
    """Numbers of the processes of a batch."""
    found = subprocess.run(["pgrep", "--full", f"batch {pairs} -o {out} "], capture_output=True,
                           text=True)
    return [int(line) for line in found.stdout.split()]


def by_slurm(program, pairs, out, tasks, kills, pause):
    os.environ["ISOMATCH_PROGRAM"] = str(program)
    words = [ROOT / "cluster/array.sbatch", pairs, out]
    how = ["--parsable", "--cpus-per-task=1", "--mem=0", "--chdir", out.parent]
    job = run(["sbatch", *how, f"--array=1-{tasks}", *words]).strip()
    run(["sbatch", *how, f"--dependency=afterany:{job}", *words, "--merge"])
    killer = Killer(kills, pause, lambda: programs_of(pairs, out))
    while run(["squeue", "--noheader"]):
        time.sleep(0.5)
    return killer.stop()


def by_dask(pairs, out, tasks, kills, pause):
    from distributed import Client, LocalCluster

    with LocalCluster(n_workers=CORES, threads_per_worker=1, processes=True,
                      dashboard_address=None) as cluster, Client(cluster) as client:
        workers = lambda: list(client.run(os.getpid, on_error="ignore").values())
        killer = Killer(kills, pause, workers)
        isomatch.batch(pairs, out, client=client, shards=tasks)
        return killer.stop()


def judged(pairs, out, expected):
    """How many pairs are lost, were matched twice and are of other bytes."""
    names = [f"{a.stem}__{b.stem}" for a, b in pairs]
    found = isomatch.Batch(out)
    lost = sum(row["outcome"] != "matched" for row in found.table) + len(set(names) - set(found))
    new = collections.Counter(
        line.split(":")[0] for log in out.glob("batch-*-of-*.log") for line in log.open()
        if not line.endswith("(earlier)\n"))
    twice = sum(count > 1 for count in new.values())
    other = sum(any(not filecmp.cmp(out / name / file, expected / name / file, False)
                    for file in MAP_FILES) for name in names)
    return lost, twice, other


def timed(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "cluster.md")
    parser.add_argument("--shapes", type=int, default=101)
    parser.add_argument("--vertices", type=int, default=20)
    parser.add_argument("--tasks", type=int, default=20)
    parser.add_argument("--kills", type=int, default=5)
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    with tempfile.TemporaryDirectory(prefix="isomatch-") as temporary:
        place = pathlib.Path(temporary)
        (place / "shapes").mkdir()
        files = make_shapes(arguments.shapes, arguments.vertices, place / "shapes")
        vertices = len(isomatch.read_mesh(files[0])[0])
        pairs = list(itertools.permutations(files, 2))
        listed = place / "pairs.csv"
        listed.write_text("".join(f"{a},{b}\n" for a, b in pairs))
        alone, _ = timed(lambda: run([program, "batch", listed, "-o", place / "alone", "--quiet"]))
        pause = alone / (3 * arguments.kills)  # What follows may take less time.
        with slurm(place / "slurm"):
            by_array = timed(lambda: by_slurm(program, listed, place / "array", arguments.tasks,
                                              arguments.kills, pause))
        by_workers = timed(lambda: by_dask(pairs, place / "dask", arguments.tasks,
                                           arguments.kills, pause))
        rows = [["one `isomatch batch`", f"{alone:.0f}", 0, "", "", ""]]
        wrong = []
        for name, out, (seconds, killed) in (("job array of Slurm", "array", by_array),
                                             ("workers of Dask", "dask", by_workers)):
            wrong.append(judged(pairs, place / out, place / "alone"))
            rows.append([name, f"{seconds:.0f}", killed, *wrong[-1]])
    columns = ["", "seconds", "killed", "lost", "twice", "different"]
    write_page(arguments.out, f"""# A batch on a cluster

Made by `bench/tables/cluster.py` at commit {commit()} on {machine()}.

All {len(pairs)} ordered pairs of {arguments.shapes} shapes of {vertices} vertices, with {CORES} processes at a time: in a Slurm of
one node, an array of {arguments.tasks} tasks, and as many shares for {CORES} workers of Dask. Programs of tasks and workers
were killed (SIGKILL) at random times. Wall seconds, pairs without a result, pairs that were matched twice, and pairs of
which a file of the map is not the same bytes as by one `isomatch batch`. A task of Slurm that was killed
waits some seconds before it begins again. Seconds depend on what else the machine does.

""" + "\n".join(table_head(columns) + [table_line(row) for row in rows]) + "\n")
    if any(any(counts) for counts in wrong):
        sys.exit(f"lost, twice, different: {wrong}")


if __name__ == "__main__":
    main()
