#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What the shapes that `isomatch batch` keeps take, and whether --memory bounds it, as a page in
docs/results/batch_memory.md.

Matches made-up creatures as a chain, each onto the next, on one thread. Of an unbounded chain, what
the peak grows by from pair to pair is what a kept shape takes. A long chain, of which all shapes together
need more memory than most machines have, is matched with bounds.
Usage: bench/tables/batch_memory.py [--sizes 5000 28000 42000 100000] [--kept 5] [--vertices 100000]
[--shapes 200] [--memory 0.5] [--data-sets faust5k tosca_cat28k elephant42k]
"""

import argparse
import csv
import pathlib
import tempfile

from common import (add_common_arguments, add_data_argument, commit, machine, mean, run, table_head,
                    table_line, write_page)
from data_sets import shapes


def make_creatures(program, vertices, count, folder):
    for pose in range(count):
        run([program, "synth", "--vertices", vertices, "--pose", pose, "--seed", 3, "--quiet", "-o",
             folder / f"{pose:04d}.off"])


def link_shapes(data_set, count, folder):
    folder.mkdir()
    names, ending = shapes(data_set)
    for name in sorted(names)[:count]:
        (folder / (name + ending)).symlink_to((data_set / (name + ending)).resolve())


def chain(program, folder, memory, out):
    """The peaks of memory after each pair, in MiB."""
    run([program, "batch", "--chain", folder, "--memory", memory, "--threads", 1, "--packed",
         "--quiet", "-o", out])
    with open(out / "pairs.csv", newline="") as table:
        return [float(line["peak_memory_mib"]) for line in csv.DictReader(table)]


def growth(peaks):
    """From pair to pair, where each adds a shape. The first step, if there are others, is left out:
    it has what the second match took more than the first as well."""
    steps = [after - before for before, after in zip(peaks, peaks[1:])]
    return mean(steps[1:] or steps)


def kept_line(program, name, folder, out):
    unbounded = chain(program, folder, 1000, out / "unbounded")
    nothing = chain(program, folder, 0, out / "nothing")
    return table_line([name, f"{growth(unbounded):.1f}", f"{unbounded[-1]:.0f}", f"{nothing[-1]:.0f}"])


def kept_lines(arguments, place):
    lines = []
    for vertices in arguments.sizes:
        folder = place / f"creatures{vertices}"
        make_creatures(arguments.program, vertices, arguments.kept, folder)
        lines.append(kept_line(arguments.program, f"{arguments.kept} creatures of {vertices:,}", folder,
                               place / f"kept{vertices}"))
    for name in arguments.data_sets:
        folder = place / name
        link_shapes(arguments.data / name, arguments.kept, folder)
        lines.append(kept_line(arguments.program, name, folder, place / f"kept-{name}"))
    return lines


def bounded_lines(arguments, place):
    folder = place / "long"
    make_creatures(arguments.program, arguments.vertices, arguments.shapes, folder)
    lines = []
    for memory in arguments.memory:
        peaks = chain(arguments.program, folder, memory, place / f"long-{memory:g}")
        lines.append(table_line([f"{memory:g}", f"{peaks[len(peaks) // 2]:.0f}", f"{peaks[-1]:.0f}"]))
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "batch_memory.md")
    add_data_argument(parser)
    parser.add_argument("--sizes", type=int, nargs="*", default=[5000, 28000, 42000, 100000])
    parser.add_argument("--data-sets", nargs="*", default=["faust5k", "tosca_cat28k", "elephant42k"])
    parser.add_argument("--kept", type=int, default=5)
    parser.add_argument("--vertices", type=int, default=100000)
    parser.add_argument("--shapes", type=int, default=200)
    parser.add_argument("--memory", type=float, nargs="*", default=[0.5])
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        place = pathlib.Path(temporary)
        kept = kept_lines(arguments, place)
        bounded = bounded_lines(arguments, place)
    write_page(arguments.out, f"""# Memory of many pairs

Made by `bench/tables/batch_memory.py` at commit {commit()} on {machine()}.

Chains of shapes, each matched onto the next on one thread: what a shape takes that is kept, by which
the peak grows from pair to pair, and the peak in the end, all MiB. Of three shapes it grows once only, by
what the second match took more than the first as well.

""" + "\n".join(table_head(["", "a kept shape", "peak, all kept", "peak, `--memory 0`"]) + kept) + f"""

A chain of {arguments.shapes} creatures of {arguments.vertices:,} vertices, by `--memory` in GiB: peaks in MiB after half of the pairs and in
the end.

""" + "\n".join(table_head(["`--memory`", "half way", "peak"]) + bounded) + "\n")


if __name__ == "__main__":
    main()
