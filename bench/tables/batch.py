#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What `isomatch batch` saves, and whether it survives being killed, as a page in
docs/results/batch.md.

Matches all ordered pairs of some shapes of a set once by a loop of `isomatch match`, once by `isomatch
batch`, and once by a batch that is killed at random and goes on. The maps must be the same bytes.
Usage: bench/tables/batch.py [--set faust5k] [--shapes 10] [--kills 3]
"""

import argparse
import filecmp
import itertools
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from common import (add_common_arguments, add_data_argument, commit, machine, run,
                    table_head, table_line, write_page)
from data_sets import shapes

MAP_FILES = ("source_to_target.bary.txt", "registered.ply", "correspondence.txt")


def seconds_of(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def write_list(folder, ending, names, path):
    pairs = list(itertools.permutations(names, 2))
    path.write_text("".join(f"{folder / (a + ending)},{folder / (b + ending)}\n" for a, b in pairs))
    return pairs


def loop(program, folder, ending, pairs, out):
    for source, target in pairs:
        run([program, "match", folder / (source + ending), folder / (target + ending), "-o",
             out / f"{source}__{target}", "--quiet"])


def killed(command, kills, seconds, generator):
    """Runs `command` to its end, after it was killed so many times within `seconds`. How often it
    was."""
    done = 0
    for _ in range(kills):
        process = subprocess.Popen([str(word) for word in command])
        try:
            process.wait(generator.uniform(0.1, 0.9) * seconds / kills)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            done += 1
    run(command)
    return done


def different(pairs, one, other):
    """Pairs of which a file is not the same in both folders."""
    return [f"{a}__{b}" for a, b in pairs
            if any(not filecmp.cmp(one / f"{a}__{b}" / name, other / f"{a}__{b}" / name, False)
                   for name in MAP_FILES)]


def prepared_share(out):
    """The share of the time that reports say went into preparing shapes."""
    times = [json.loads(path.read_text())["seconds"] for path in out.glob("*/report.json")]
    return (sum(t["reading"] + t["diagnosis"] + t["shapes"] for t in times) /
            sum(sum(t.values()) for t in times))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "batch.md")
    add_data_argument(parser)
    parser.add_argument("--set", default="faust5k")
    parser.add_argument("--shapes", type=int, default=10)
    parser.add_argument("--kills", type=int, default=3)
    arguments = parser.parse_args()
    folder = (arguments.data / arguments.set).resolve()
    names, ending = shapes(folder)
    names = sorted(names)[:arguments.shapes]
    with tempfile.TemporaryDirectory() as temporary:
        place = pathlib.Path(temporary)
        pairs = write_list(folder, ending, names, place / "pairs.csv")
        command = [arguments.program, "batch", place / "pairs.csv", "--quiet", "-o"]
        batch = seconds_of(lambda: run([*command, place / "batch"]))
        single = seconds_of(lambda: loop(arguments.program, folder, ending, pairs, place / "loop"))
        kills = killed([*command, place / "killed", "--resume"], arguments.kills, batch,
                       random.Random(0))
        results = {"a loop of `isomatch match`": (single, different(pairs, place / "loop",
                                                                    place / "batch")),
                   "`isomatch batch`": (batch, []),
                   f"the same, killed {kills} times and resumed":
                       (None, different(pairs, place / "killed", place / "batch"))}
        share = prepared_share(place / "loop")
    lines = [table_line([name, "" if seconds is None else f"{seconds:.1f}",
                         "" if seconds is None else f"{seconds / single:.2f}", len(wrong)])
             for name, (seconds, wrong) in results.items()]
    write_page(arguments.out, f"""# Many pairs

Made by `bench/tables/batch.py` at commit {commit()} on {machine()}.

All {len(pairs)} ordered pairs of {len(names)} shapes of {arguments.set}, wall seconds of all, their ratio, and pairs of
which a file of the map is not the same bytes as by `isomatch batch`. In the loop {100 * share:.0f} % of the
time goes into reading and preparing shapes.

""" + "\n".join(table_head(["", "seconds", "ratio", "different"]) + lines) + "\n")
    if any(wrong for _, wrong in results.values()):
        sys.exit("there are pairs with other results: " + str(results))


if __name__ == "__main__":
    main()
