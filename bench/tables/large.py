#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Time, memory and accuracy of the tracked method on large meshes, as a table in
docs/results/large.md.

Pairs of creatures of 5k to 1M vertices from `isomatch synth`, one of 5M against 1M, a pair of
elephants of 42k and one of 169k as they are and divided at the middles of their edges. Needs the data
folder for the elephants. Usage: bench/tables/large.py [--program build/release/tools/isomatch]
"""

import argparse
import filecmp
import json
import math
import pathlib
import sys
import tempfile
import time

import numpy

from common import (add_common_arguments, add_data_argument, commit, evaluate, machine, run,
                    table_head, table_line, write_page)
from scaling import exponent

SIZES = [5000, 10000, 20000, 40000, 80000, 160000, 320000, 640000, 1000000]
HUGE = 5000000
# Set, source and target, and how often to divide both.
ELEPHANTS = [("elephant42k", names, divisions)
             for names in (("elephant_1", "elephant_8"), ("elephant_8", "elephant_4"),
                           ("elephant_4", "elephant_1")) for divisions in range(3)]
ELEPHANTS += [("elephant169k", ("elephant_gallop_1", "elephant_gallop_20"), divisions)
              for divisions in (0, 2)]
STAGES = ["reading", "diagnosis", "shapes", "hypotheses", "refinement", "dense map", "writing"]
POINT_ERROR = "point_error_over_sqrt_area"


def read_ply(path):
    """Vertices and faces of a binary PLY file of doubles or floats and triangles."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode().split("\n")
    counts = {line.split()[1]: int(line.split()[2]) for line in header
              if line.startswith("element")}
    real = "<f8" if any(line.startswith("property double x") for line in header) else "<f4"
    vertices = numpy.frombuffer(data, real, 3 * counts["vertex"], end).reshape(-1, 3)
    face = numpy.dtype([("count", "u1"), ("corners", "<i4", 3)])
    faces = numpy.frombuffer(data, face, counts["face"], end + vertices.nbytes)
    return vertices.astype("<f8"), faces["corners"]


def write_ply(path, vertices, faces):
    rows = numpy.empty(len(faces), numpy.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    rows["count"], rows["corners"] = 3, faces
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}",
              *(f"property double {axis}" for axis in "xyz"), f"element face {len(faces)}",
              "property list uchar int vertex_indices", "end_header", ""]
    path.write_bytes("\n".join(header).encode() + vertices.astype("<f8").tobytes() +
                     rows.tobytes())


def divided(vertices, faces):
    """Each triangle divided into four at the middles of its edges; old vertices keep their numbers."""
    edges = numpy.sort(faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    different, place = numpy.unique(edges, axis=0, return_inverse=True)
    middles = vertices[different].mean(axis=1)
    a, b, c = faces.T
    ab, bc, ca = (place.reshape(-1, 3) + len(vertices)).T
    quarters = [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return (numpy.concatenate([vertices, middles]),
            numpy.concatenate([numpy.stack(corners, axis=1) for corners in quarters]))


# The corners of the quarters of a triangle, as barycentric coordinates.
QUARTERS = numpy.array([[[2, 0, 0], [1, 1, 0], [1, 0, 1]], [[0, 2, 0], [0, 1, 1], [1, 1, 0]],
                        [[0, 0, 2], [1, 0, 1], [0, 1, 1]], [[1, 1, 0], [0, 1, 1], [1, 0, 1]]]) / 2


def undivided(triangles, weights, faces):
    """Points on a divided mesh as points on the one of `faces` triangles that was divided."""
    return triangles % faces, numpy.einsum("ij,ijk->ik", weights, QUARTERS[triangles // faces])


class Pair:
    """Two mesh files, how often they were divided, and the files and truths to evaluate a map on."""

    def __init__(self, name, meshes, truths, originals=None, divisions=0):
        self.name, self.meshes, self.truths = name, meshes, truths
        self.originals, self.divisions = originals or meshes, divisions

    def map_of_originals(self, folder):
        """The file of a map between the divided meshes, reduced to those that were divided."""
        path = folder / "source_to_target.bary.txt"
        if not self.divisions:
            return path
        vertices, faces = (len(read_ply(mesh)[k]) for k, mesh in enumerate(self.originals))
        rows = numpy.loadtxt(path, max_rows=vertices)
        triangles, weights = rows[:, 0].astype(int), rows[:, 1:]
        for division in reversed(range(self.divisions)):
            triangles, weights = undivided(triangles, weights, faces * 4**division)
        reduced = folder / "originals.bary.txt"
        numpy.savetxt(reduced, numpy.column_stack([triangles, weights]), "%d %.17g %.17g %.17g")
        return reduced


class Figures:
    def __init__(self, pair, seconds, report, error):
        self.pair, self.seconds, self.report, self.error = pair, seconds, report, error
        self.vertices = max(report["source"]["vertices"], report["target"]["vertices"])

    @property
    def cells(self):
        sizes = [f"{self.report[side]['vertices']:,}" for side in ("source", "target")]
        stages = [f"{self.report['seconds'].get(stage, 0):.2f}" for stage in STAGES]
        return [self.pair.name, *sizes, f"{self.seconds:.2f}", *stages,
                f"{self.report['peak_memory_mib']:.0f}", self.error]


def match(arguments, pair, folder, threads=None):
    out = folder / f"out{threads or ''}"
    options = ["--threads", threads] if threads else []
    start = time.perf_counter()
    run([arguments.program, "match", *pair.meshes, "-o", out, "--quiet", *options])
    return out, time.perf_counter() - start


def mean_error(arguments, pair, out):
    options = ["--gt-source", pair.truths[0], "--gt-target", pair.truths[1]]
    evaluation = evaluate(arguments.program, *pair.originals, pair.map_of_originals(out), options)
    return f"{100 * evaluation['ground_truth'][POINT_ERROR]['mean']:.2f}"


def measure(arguments, pair, folder, with_error=True):
    out, seconds = match(arguments, pair, folder)
    report = json.loads((out / "report.json").read_text())
    figures = Figures(pair, seconds, report, mean_error(arguments, pair, out) if with_error else "")
    print("  ".join(figures.cells), file=sys.stderr, flush=True)
    return figures


def creature(arguments, folder, vertices, pose):
    path = folder / f"creature{vertices}_{pose}.ply"
    if not path.exists():
        run([arguments.program, "synth", "--vertices", vertices, "--pose", pose, "-o", path])
    return path


def creatures(arguments, folder, sizes):
    meshes = [creature(arguments, folder, n, pose) for n, pose in zip(sizes, (1, 2))]
    return Pair("creatures", meshes, [mesh.with_suffix(".vts") for mesh in meshes])


def elephants(arguments, folder, kind, names, divisions):
    """Two elephants of a set as they are and divided so many times."""
    given = arguments.data / kind
    truths = [given / "corres" / f"{name}.vts" for name in names]
    originals = [given / f"{name}.ply" for name in names]
    if divisions == 0:
        return Pair(kind, originals, truths)
    paths = [folder / f"{name}.ply" for name in names]
    for name, path in zip(names, paths):
        mesh = read_ply(given / f"{name}.ply")
        for _ in range(divisions):
            mesh = divided(*mesh)
        write_ply(path, *mesh)
    return Pair(f"{kind}, divided {('', 'once', 'twice')[divisions]}", paths, truths,
                originals, divisions)


def same_bytes(arguments, pair, folder):
    """Whether one and two threads write the same files, but for the times in report.json."""
    one, two = (match(arguments, pair, folder, threads)[0] for threads in (1, 2))
    names = sorted(path.name for path in one.iterdir() if path.name != "report.json")
    return filecmp.cmpfiles(one, two, names, shallow=False)[0] == names


TEXT = """# Large meshes

Made by `bench/tables/large.py` at commit {commit} on {machine}.

Whole program, meshes read from binary PLY; wall seconds and those of each stage, peak memory in MiB,
mean error of the map to points on triangles, x100 over sqrt(area). Creatures are measured at some
{points} points that all sizes have, whose truth is a nearest vertex; elephants at all vertices
that they have before they are divided, on the mesh as it was then. The least squares fit of the whole program's time from 5k to 1M is N^{power:.2f}.
One thread and two write the same bytes for the 1M pair: {same}.

"""


def profile(figures):
    """Share of the time and memory so far of each stage."""
    report = figures.report
    lines = table_head(["stage", "seconds", "share", "peak MiB by its end"])
    lines += [table_line([stage, f"{report['seconds'][stage]:.2f}",
                          f"{report['seconds'][stage] / figures.seconds:.0%}",
                          f"{report['peak_memory_mib_after'][stage]:.0f}"]) for stage in STAGES]
    return "\n".join(lines)


def resolution(figures):
    """How the error of the same pairs depends on how finely they are divided."""
    means = []
    for divisions in range(3):
        errors = [float(f.error) for f in figures
                  if f.pair.name.startswith("elephant42k") and f.pair.divisions == divisions]
        means.append(sum(errors) / len(errors))
    return ("Mean error of the three pairs of elephant42k as they are, divided once and twice: " +
            ", ".join(f"{error:.2f}" for error in means) + ".")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "large.md")
    add_data_argument(parser)
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        series = [measure(arguments, creatures(arguments, folder, (n, n)), folder) for n in SIZES]
        million = creatures(arguments, folder, (SIZES[-1], SIZES[-1]))
        same = same_bytes(arguments, million, folder)
        rest = [measure(arguments, creatures(arguments, folder, (HUGE, SIZES[-1])), folder,
                        with_error=False)]
        divided_elephants = [measure(arguments, elephants(arguments, folder, *entry), folder)
                             for entry in ELEPHANTS]
        points = len(million.truths[0].read_text().split())
    power = exponent([f.vertices for f in series], [f.seconds for f in series])
    columns = ["pair", "source", "target", "whole program", *STAGES, "peak MiB", "error"]
    text = TEXT.format(commit=commit(), machine=machine(), power=power, points=points,
                       same="yes" if same else "NO")
    lines = [table_line(f.cells) for f in series + rest + divided_elephants]
    text += "\n".join(table_head(columns) + lines)
    text += "\n\n" + resolution(divided_elephants)
    text += "\n\n## The pair of 1M creatures\n\n" + profile(series[-1]) + "\n"
    write_page(arguments.out, text)
    print(f"exponent {power:.3f}, same bytes with one and two threads: {same}")


if __name__ == "__main__":
    main()
