# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Runs `isomatch-bench`, which measures all methods, and remembers what it said."""

import argparse
import json
import pathlib
import sys
import time

from common import ROOT, add_data_argument, commit, machine, mean, run

METHODS = ("paper", "tracked", "spectral", "gmds", "zoomout")
# Everything that a table shows, so that no pair is matched twice.
MAPS = ("final", "many_to_many", "bases", "level4_many_to_one", "level5_many_to_one")
SAMPLES = 1000  # Ground-truth errors of a map, evenly spaced.


class Measured:
    """One map of one method on one pair."""

    def __init__(self, pair, method, name, result):
        self.pair, self.method, self.name = pair, method, name
        self.seconds, self.peak_mib = result["seconds"], result["peak_memory_mib"]
        self.levels = result.get("levels", [])
        figures = result["maps"][name]
        self.matches = figures["matches"]
        self.d_iso = figures["d_iso_over_max_geodesic"]["mean"]
        self.d_iso_max = figures["d_iso_over_max_geodesic"]["maximum"]
        self.flipped = figures.get("flipped", figures["orientation"]["verdict"] == "reverses")
        self.truth = figures.get("ground_truth")
        self.symmetric = figures.get("symmetric_ground_truth", self.truth)

    @property
    def d_grd(self):
        return self.truth["d_grd_over_max_geodesic"]["mean"]

    @property
    def d_grd_max(self):
        return self.truth["d_grd_over_max_geodesic"]["maximum"]

    def error(self, kind="error"):
        """Mean error x100 over sqrt(area); of points on triangles if `kind` is point_error."""
        return 100 * self.truth[f"{kind}_over_sqrt_area"]["mean"]

    def flip_allowed(self):
        """The error against the truth or its mirror image, whichever is less."""
        return min(100 * truth["error_over_sqrt_area"]["mean"]
                   for truth in (self.truth, self.symmetric))

    def curve(self, flips_allowed=False):
        truth = self.symmetric if flips_allowed and self.flipped else self.truth
        return truth["cumulative"]


class Failure:
    """A method that made no map of a pair, and why."""

    def __init__(self, pair, method, reason):
        self.pair, self.method, self.reason = pair, method, reason


class Bench:
    """Measures pairs, each with each method once."""

    def __init__(self, program):
        self.program = program
        self.results = {}

    def measure(self, pair, methods):
        """What `isomatch-bench` says of each method."""
        known = self.results.setdefault(tuple(pair.meshes), {})
        missing = [method for method in methods if method not in known]
        if missing:
            start = time.perf_counter()
            report = json.loads(run([self.program, *pair.meshes, *pair.truth, "--quiet",
                                     "--methods", ",".join(missing), "--maps", ",".join(MAPS),
                                     "--samples", SAMPLES]))
            known.update(report["methods"])
            print(f"{pair.name}: {', '.join(missing)}: {time.perf_counter() - start:.1f} s",
                  file=sys.stderr, flush=True)
        return {method: known[method] for method in methods}

    def map(self, pair, method, name="final"):
        result = self.measure(pair, [method])[method]
        if "failure" in result:
            return Failure(pair, method, result["failure"])
        return Measured(pair, method, name, result)


def figure(values, digits=3):
    """The mean in the paper's style: .021."""
    values = list(values)
    return f"{mean(values):.{digits}f}".lstrip("0") if values else "–"


def behind(column, value, rivals):
    """What is better than tracked's `value` in a column, where less is better."""
    return [f"{column}: {name} {other}" for name, other in rivals.items()
            if float(other) < float(value)]


def verdict(remarks):
    return "yes" if not remarks else "**no**: " + "; ".join(remarks)


def provenance(command):
    return f"Made by `{command}` at commit {commit()} on {machine()}."


def run_table(description, make):
    """The main function of a table's script: `make(bench, data, folder, quick, command)`."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path,
                        default=ROOT / "build/release/baselines/isomatch-bench")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/results",
                        help="folder of the pages")
    parser.add_argument("--quick", action="store_true", help="one or two pairs of each set")
    add_data_argument(parser)
    arguments = parser.parse_args()
    command = " ".join([str(pathlib.Path(sys.argv[0]).resolve().relative_to(ROOT)),
                        *(["--quick"] if arguments.quick else [])])
    make(Bench(arguments.program), arguments.data, arguments.out, arguments.quick, command)
