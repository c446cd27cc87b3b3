# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Runs `isomatch-bench`, which measures all methods, and remembers what it said."""

import argparse
import hashlib
import json
import pathlib
import sys
import time

import numpy as np

from common import ROOT, add_data_argument, commit, machine, mean, run

METHODS = ("paper", "paper-oriented", "tracked", "spectral", "gmds", "zoomout")
# Everything that a table shows, so that no pair is matched twice.
MAPS = ("final", "many_to_many", "bases", "level4_many_to_one", "level5_many_to_one")
SAMPLES = 1000  # Ground-truth errors of a map, evenly spaced.
STEP = 0.005  # Between the thresholds of cumulative errors, over sqrt(area).


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
        self.truth = figures.get("ground_truth", figures.get("ground_truth_map"))
        self.symmetric = figures.get("symmetric_ground_truth", self.truth)
        # Of what errors over sqrt(area) of the target are to be multiplied with.
        self.unit = pair.error_unit(result["target_area"])

    @property
    def d_grd(self):
        return self.truth["d_grd_over_max_geodesic"]["mean"]

    @property
    def d_grd_max(self):
        return self.truth["d_grd_over_max_geodesic"]["maximum"]

    def error(self, kind="error"):
        """Mean error x100 over sqrt(area); of points on triangles if `kind` is point_error."""
        return 100 * self.unit * self.truth[f"{kind}_over_sqrt_area"]["mean"]

    @property
    def overlap_iou(self):
        """Intersection over union of what is matched and what has a counterpart, by area."""
        return self.truth["overlap"]["iou"]

    def flip_allowed(self):
        """The error against the truth or its mirror image, whichever is less."""
        return min(100 * self.unit * truth["error_over_sqrt_area"]["mean"]
                   for truth in (self.truth, self.symmetric))

    def curve(self, flips_allowed=False):
        truth = self.symmetric if flips_allowed and self.flipped else self.truth
        thresholds = STEP * np.arange(len(truth["cumulative"]))
        return np.interp(thresholds / self.unit, thresholds, truth["cumulative"]).tolist()


class Failure:
    """A method that made no map of a pair, and why."""

    def __init__(self, pair, method, reason):
        self.pair, self.method, self.reason = pair, method, reason


class Bench:
    """Measures pairs, each with each method once, and keeps the results in a folder, for the same
    program, so that what was measured by an earlier run is not measured again."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = folder / hashlib.sha256(program.read_bytes()).hexdigest()[:16]

    def measure(self, pair, methods):
        """What `isomatch-bench` says of each method."""
        files = {method: self.file_of(pair, method) for method in methods}
        missing = [method for method, file in files.items() if not file.exists()]
        if missing:
            start = time.perf_counter()
            self.run(pair, {method: files[method] for method in missing})
            print(f"{pair.name}: {', '.join(missing)}: {time.perf_counter() - start:.1f} s",
                  file=sys.stderr, flush=True)
        return {method: json.loads(file.read_text()) for method, file in files.items()}

    def file_of(self, pair, method):
        names = [f"{mesh.parent.name}-{mesh.stem}" for mesh in pair.meshes]
        return self.folder / "__".join(names) / f"{method}-{SAMPLES}.json"

    def run(self, pair, files):
        report = json.loads(run([self.program, *pair.meshes, *pair.truth, "--quiet", "--methods",
                                 ",".join(files), "--maps", ",".join(MAPS), "--samples", SAMPLES]))
        for method, file in files.items():
            result = report["methods"][method]
            result["target_area"] = report["target"]["area"]
            file.parent.mkdir(parents=True, exist_ok=True)
            unfinished = file.with_suffix(".unfinished")
            unfinished.write_text(json.dumps(result))
            unfinished.replace(file)

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
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "build/tables",
                        help="folder of what was measured, which later runs use")
    add_data_argument(parser)
    arguments = parser.parse_args()
    command = " ".join([str(pathlib.Path(sys.argv[0]).resolve().relative_to(ROOT)),
                        *(["--quick"] if arguments.quick else [])])
    commit()
    make(Bench(arguments.program, arguments.results), arguments.data, arguments.out,
         arguments.quick, command)
