#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What matching a collection gains over matching its pairs, as a page in docs/results/group.md.

Runs `isomatch group` and `isomatch batch --all` on collections, and measures the maps of both between
all ordered pairs. Also measures how far cycles of three shapes are from closing. Needs the Python
package, see docs/python.md.
Usage: bench/tables/group.py [--sets faust5k,cats,smal5k] [--pairs 100] [--work DIR]
With --work, batches and groups that are there are used again.
"""

import argparse
import concurrent.futures
import functools
import itertools
import json
import os
import pathlib
import random
import tempfile
import time

import numpy as np
from common import (add_common_arguments, add_data_argument, commit, machine, mean, percentile, run,
                    table_head, table_line, write_page)
from data_sets import shapes

import isomatch

# Folder and beginning of the names.
SETS = {"faust5k": ("faust5k", ""), "cats": ("tosca5k", "cat"), "smal5k": ("smal5k", "")}
CLOSED = 0.02  # Of sqrt(area): what a cycle may be off.
CYCLES = 200


class Collection:
    """The shapes of a set, in a folder of their own, and where the maps between them are."""

    def __init__(self, arguments, title, place):
        folder, beginning = SETS[title]
        self.title, self.program = title, arguments.program
        self.data = (arguments.data / folder).resolve()
        names, self.ending = shapes(self.data, beginning)
        self.names = sorted(names)
        self.place = place / title
        self.scans = self.place / "shapes"
        self.scans.mkdir(parents=True, exist_ok=True)
        for name in self.names:
            link = self.scans / (name + self.ending)
            if not link.exists():
                link.symlink_to(self.data / (name + self.ending))
        self.pairs = list(itertools.permutations(self.names, 2))

    @functools.cache
    def shape(self, name):
        return isomatch.Shape(self.scans / (name + self.ending))

    def truth(self, source, target):
        """Lists of corresponding vertices, a third one of the target under its symmetry if known."""
        lists = [self.data / "corres" / f"{name}.vts" for name in (source, target)]
        mirrored = lists[1].with_suffix(".sym.vts")
        return [*lists, mirrored] if mirrored.exists() else lists

    def group(self):
        out = self.place / "group"
        if not (out / "report.json").exists():
            run([self.program, "group", self.scans, "-o", out, "--all-maps", "--quiet"])
        return out

    def batch(self):
        out = self.place / "batch"
        run([self.program, "batch", "--all", self.scans, "-o", out, "--resume", "--quiet"])
        return out

    def map(self, kind, pair):
        source, target = pair
        if kind == "group":
            return isomatch.read_map(self.place / "group/maps" / f"{source}__{target}.bary.txt")
        return isomatch.read_map(self.place / "batch" / f"{source}__{target}" /
                                 "source_to_target.bary.txt")


def figures(collection, kind, pairs, jobs):
    """Mean errors of the maps, of points and of vertices, x100 over sqrt(area), and which of the
    maps are flipped."""
    def one(pair):
        # Distortion is not shown.
        found = isomatch.evaluate(*map(collection.shape, pair), collection.map(kind, pair),
                                  collection.truth(*pair), threads=1, list_size=1)
        errors = found["ground_truth"]
        return (100 * errors["point_error_over_sqrt_area"]["mean"],
                100 * errors["error_over_sqrt_area"]["mean"],
                found.get("flipped", found["orientation"]["verdict"] == "reverses"))

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(one, pairs))


def closed_share(collection, kind, generator):
    """The share of the vertices that come back within `CLOSED` after a cycle of three shapes, over
    random cycles."""
    closed = total = 0
    for _ in range(CYCLES):
        cycle = generator.sample(collection.names, 3)
        vertices = collection.shape(cycle[0]).vertices
        # Positions of the vertices, carried linearly over each triangle.
        there = vertices
        for source, target in ((cycle[2], cycle[0]), (cycle[1], cycle[2]), (cycle[0], cycle[1])):
            carried = collection.map(kind, (source, target))
            corners = there[collection.shape(target).faces[carried.triangles]]
            image = (corners * carried.barycentric[:, :, None]).sum(1)
            there = np.where(carried.triangles[:, None] < 0, np.nan, image)
        off = np.linalg.norm(there - vertices, axis=1)
        closed += np.sum(off <= CLOSED * np.sqrt(collection.shape(cycle[0]).area))
        total += np.sum(np.isfinite(off))
    return closed / total


def measured(arguments, title, place):
    collection = Collection(arguments, title, place)
    begun = time.perf_counter()
    report = json.loads((collection.group() / "report.json").read_text())
    print(f"{title}: group {time.perf_counter() - begun:.0f} s", flush=True)
    collection.batch()
    print(f"{title}: batch {time.perf_counter() - begun:.0f} s", flush=True)
    pairs = collection.pairs
    if arguments.pairs and arguments.pairs < len(pairs):
        pairs = random.Random(0).sample(pairs, arguments.pairs)
    lines = []
    for kind in ("batch", "group"):
        found = figures(collection, kind, pairs, arguments.jobs)
        points = [f[0] for f in found]
        closed = closed_share(collection, kind, random.Random(0))
        matched = len(collection.pairs) if kind == "batch" else report["pairs"]
        lines.append(table_line([
            title, "each pair by itself" if kind == "batch" else "as a group", matched,
            f"{mean(f[1] for f in found):.2f}", f"{mean(points):.3f}",
            f"{percentile(points, 0.5):.3f}", f"{percentile(points, 0.95):.2f}",
            f"{max(points):.2f}", sum(f[2] for f in found), f"{100 * closed:.1f}"]))
        print(lines[-1], flush=True)
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "group.md")
    add_data_argument(parser)
    parser.add_argument("--sets", default=",".join(SETS))
    parser.add_argument("--pairs", type=int, help="evaluate so many pairs of each set only")
    parser.add_argument("--work", type=pathlib.Path, help="folder that is kept")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="evaluations at a time")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        place = (arguments.work or pathlib.Path(temporary)).resolve()
        lines = [line for title in arguments.sets.split(",")
                 for line in measured(arguments, title, place)]
    columns = ["data", "maps", "pairs matched", "vertices", "points: mean", "median", "95 %",
               "worst pair", "flipped", f"closed within {CLOSED} %"]
    write_page(arguments.out, f"""# Collections

Made by `bench/tables/group.py` at commit {commit()} on {machine()}.

Errors of the maps between all ordered pairs of a set{f' ({arguments.pairs} of them, drawn at random)'
if arguments.pairs else ''}, x100 over sqrt(area), from the usual truth: of the nearest vertices, and of
points on triangles, with the mean, median, 95th percentile and maximum over the pairs. *Closed* is the
share of the vertices that come back within {CLOSED} sqrt(area) of where they began over {CYCLES} random
cycles of three shapes. A group matches each shape with the template and with those most like it; its
maps between all others are composed.

""" + "\n".join(table_head(columns) + lines) + "\n")


if __name__ == "__main__":
    main()
