#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Time of the paper's method against mesh size, as a table in docs/results/scaling.md.

Makes pairs of creatures with `isomatch synth`, matches them, and fits cost = c N^p to the matching
stages. Usage: bench/tables/scaling.py [--program build/release/tools/isomatch] [--largest 128000]
"""

import argparse
import json
import math
import pathlib
import tempfile
import time

from common import add_common_arguments, commit, machine, run, table_head, table_line, write_page

SMALLEST = 2000
REPETITIONS = 3
STAGES = ["reading", "diagnosis", "geodesic graph", "saliency", "sampling", "patch matching",
          "merging"]


def synthesize(program, folder, vertices, pose):
    path = folder / f"pose{pose}.ply"
    run([program, "synth", "--shape", "creature", "--vertices", vertices, "--pose", pose,
         "--seed", 1, "-o", path])
    return path


def measure(program, vertices):
    """Median over some runs of the wall time and the time of each stage."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        source, target = (synthesize(program, folder, vertices, pose) for pose in (1, 2))
        runs = []
        for _ in range(REPETITIONS):
            start = time.perf_counter()
            run([program, "match", source, target, "--method", "paper", "-o", folder / "out",
                 "--quiet"])
            seconds = time.perf_counter() - start
            report = json.loads((folder / "out/report.json").read_text())
            runs.append((seconds, report))
    seconds, report = sorted(runs, key=lambda entry: entry[0])[REPETITIONS // 2]
    return {"vertices": report["source"]["vertices"], "seconds": seconds,
            "stages": report["seconds"], "memory": report["peak_memory_mib"],
            "d_iso": report["distortion"]["d_iso_mean"]}


def exponent(sizes, seconds):
    """Least squares slope of log(seconds) over log(sizes)."""
    x, y = [math.log(n) for n in sizes], [math.log(s) for s in seconds]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def row(figures):
    cells = [f"{figures['vertices']:,}", f"{figures['seconds']:.2f}"]
    cells += [f"{figures['stages'][stage]:.2f}" for stage in STAGES]
    cells += [f"{figures['memory']:.0f}", f"{figures['d_iso']:.4f}"]
    return table_line(cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "scaling.md")
    parser.add_argument("--largest", type=int, default=128000)
    arguments = parser.parse_args()
    results, vertices = [], SMALLEST
    while vertices <= arguments.largest:
        results.append(measure(arguments.program, vertices))
        print(row(results[-1]), flush=True)
        vertices *= 2
    sizes = [r["vertices"] for r in results]
    power = exponent(sizes, [r["seconds"] for r in results])
    columns = ["vertices", "whole program"] + STAGES + ["peak MiB", "D_iso"]
    text = ["# Time of the paper's method against mesh size", "",
            f"Made by `bench/tables/scaling.py` at commit {commit()} on {machine()}.", "",
            f"Pairs of creatures from `isomatch synth`; seconds, median of {REPETITIONS} runs. The",
            f"least squares fit of the whole program's time is N^{power:.2f}; N log N over this range",
            f"is N^{exponent(sizes, [n * math.log(n) for n in sizes]):.2f}.", "",
            *table_head(columns)]
    write_page(arguments.out, "\n".join(text + [row(r) for r in results]) + "\n")
    print(f"exponent {power:.3f}")


if __name__ == "__main__":
    main()
