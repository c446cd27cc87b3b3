#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What changes when the tracked method is given the same shapes in another form, as a table in
docs/results/tracked_invariance.md.

Usage: bench/tables/tracked_invariance.py [--program build/release/tools/isomatch] [--pairs 3]
"""

import argparse
import pathlib
import sys
import tempfile

import data_sets
import meshes
from common import (add_common_arguments, add_data_argument, commit, evaluate, machine, mean, run,
                    table_head, table_line, write_page)

SETS = ("faust5k", "tosca5k")


def edge_noise(shape):
    return meshes.noisy(shape, 0.01 * meshes.mean_edge(shape))


def area_noise(shape):
    return meshes.noisy(shape, 0.001 * meshes.sqrt_area(shape))


def same(shape):
    return shape


def exchanged_truth(shape):
    return shape.changed(truth=shape.symmetric, symmetric=shape.truth)


def mirrored_onto(shape):
    """The right map to the mirror image of a shape is the one that exchanges left and right."""
    return exchanged_truth(meshes.mirrored(shape))


# What becomes of the source and of the target.
VARIANTS = {"source scaled by 37.5": (meshes.scaled, same),
            "target scaled by 37.5": (same, meshes.scaled),
            "source turned and moved": (meshes.moved, same),
            "target turned and moved": (same, meshes.moved),
            "both mirrored": (meshes.mirrored, meshes.mirrored),
            "target mirrored": (same, mirrored_onto),
            "faces of the target turned over": (same, meshes.turned_over),
            "source relabelled": (meshes.relabelled, same),
            "target relabelled": (same, meshes.relabelled),
            "source subdivided": (meshes.subdivided, same),
            "target subdivided": (same, meshes.subdivided),
            "both subdivided": (meshes.subdivided, meshes.subdivided),
            "noise of 1 % of an edge on both": (edge_noise, edge_noise),
            "noise of .1 % of sqrt(area) on both": (area_noise, area_noise)}


def match(program, folder, threads=None):
    """Matches the shapes in `folder`; the errors of points, x100, and whether the map is flipped."""
    shapes = [folder / f"{side}.off" for side in ("source", "target")]
    run([program, "match", *shapes, "-o", folder / "out", "--quiet",
         *(["--threads", threads] if threads else [])])
    evaluation = evaluate(program, *shapes, folder / "out/source_to_target.bary.txt",
                          ["--gt-source", folder / "source.vts",
                           "--gt-target", folder / "target.vts",
                           "--gt-target-sym", folder / "target.sym.vts"])
    error = 100 * evaluation["ground_truth"]["point_error_over_sqrt_area"]["mean"]
    return error, evaluation["flipped"]


def outputs(folder):
    """All files of the result but the report, which has times."""
    return {path.name: path.read_bytes() for path in (folder / "out").iterdir()
            if path.is_file() and path.name != "report.json"}


def threads_change_nothing(program, folder):
    results = []
    for threads in (1, 2):
        match(program, folder, threads)
        results.append(outputs(folder))
    return results[0] == results[1]


class Changes:
    """Errors of the pairs in one form, beside those of the pairs as they are."""

    def __init__(self):
        self.pairs, self.errors, self.differences, self.flips = [], [], [], 0

    def add(self, pair, error, is_flipped, plain):
        self.pairs.append(pair.name)
        self.errors.append(error)
        self.differences.append(error - plain)
        self.flips += is_flipped

    def cells(self):
        largest = max(range(len(self.pairs)), key=lambda i: abs(self.differences[i]))
        return [f"{mean(self.errors):.2f}", f"{mean(self.differences):+.2f}",
                f"{self.differences[largest]:+.2f} ({self.pairs[largest]})", self.flips]


def measure(program, pair, changes):
    """Adds all variants of a pair to `changes`; whether threads change nothing."""
    source, target = (meshes.read_shape(pair.folder, name) for name in (pair.source, pair.target))
    plain = None
    for title, (change_source, change_target) in {"as it is": (same, same), **VARIANTS}.items():
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            meshes.write_shape(change_source(source), folder, "source")
            meshes.write_shape(change_target(target), folder, "target")
            error, is_flipped = match(program, folder)
            if plain is None:
                plain = error
                is_same = threads_change_nothing(program, folder)
        changes.setdefault(title, Changes()).add(pair, error, is_flipped, plain)
        print(f"{pair.name}: {title}: {error:.2f} ({error - plain:+.2f})", file=sys.stderr,
              flush=True)
    return is_same


HEADER = """# The tracked method on the same shapes in another form

Made by `bench/tables/tracked_invariance.py` at commit {commit} on {machine}, on {pairs} pairs: {names}.

Errors are mean geodesic distances of the map to points on triangles from the ground truth, x100 over
sqrt(area) of the target. *Mirrored* shapes have their faces turned so that they are seen from
outside as before; to the mirror image of a shape alone the right map is the one that exchanges left
and right, so its error is measured against the symmetric ground truth. *Subdivided* meshes have each
triangle divided into four, so about 20,000 vertices; the truth stays at the old ones. *Noise* is
Gaussian in every coordinate, with the standard deviation that is named.

"""

COLUMNS = ["form", "mean error", "mean change", "largest change", "flipped"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "tracked_invariance.md")
    add_data_argument(parser)
    parser.add_argument("--pairs", type=int, default=3, help="of each set")
    arguments = parser.parse_args()
    sets = data_sets.pairs_with_truth(arguments.data)
    pairs = [pair for title in SETS for pair in sets[title][:arguments.pairs]]
    changes = {}
    are_same = [measure(arguments.program, pair, changes) for pair in pairs]
    text = HEADER.format(commit=commit(), machine=machine(), pairs=len(pairs),
                         names=", ".join(pair.name for pair in pairs))
    text += "\n".join(table_head(COLUMNS) + [table_line([title, *change.cells()])
                                             for title, change in changes.items()])
    text += (f"\n\nWith one thread and with two, all files of the result have the same bytes on "
             f"{sum(are_same)} of {len(pairs)} pairs.\n")
    print(text)
    write_page(arguments.out, text)


if __name__ == "__main__":
    main()
