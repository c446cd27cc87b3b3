#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""How far the verdict on the fit can be trusted, as a table in docs/results/verdict.md.

Right pairs of every kind, and pairs that are spoilt: a limb exchanged by false landmarks, a wrong
hypothesis forced by asking for alternatives, shapes of other species, a part cut off, the paper's
method, which turns surfaces over. Whether a map is right is measured against the ground truth where
there is one, whatever was intended.
Usage: bench/tables/verdict.py [--jobs 2] [--seed 1]
"""

import argparse
import collections
import concurrent.futures
import heapq
import json
import math
import os
import pathlib
import random
import sys
import tempfile

import data_sets
from common import (ProgramFailed, add_common_arguments, add_data_argument, commit, machine, run,
                    table_head, table_line, write_page)

GRADES = ("good", "doubtful", "poor")
# A map is right if less than a hundredth of the points of the truth are off by more than a tenth of
# sqrt(area), and wrong if more than three hundredths are; half a paw lies between.
OFF, RIGHT, WRONG = 0.1, 0.01, 0.03


class Case(collections.namedtuple("Case", "kind source target truth options spoil")):
    """A pair of mesh files, lists of corresponding vertices or None, options of `isomatch match`,
    and what is done to the pair before, a function of the meshes, or None."""

    @property
    def name(self):
        return f"{self.source.stem} {self.target.stem}"


class Mesh:
    """Vertices and triangles of an OFF file."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = vertices, faces

    @staticmethod
    def load(program, path, folder):
        file = folder / f"{path.stem}.{path.parent.name}.off"
        run([program, "convert", path, file, "--quiet"])
        words = file.read_text().split()
        count, faces = int(words[1]), int(words[2])
        numbers = list(map(float, words[4:4 + 3 * count]))
        corners = list(map(int, words[4 + 3 * count:]))
        return Mesh([numbers[3 * i:3 * i + 3] for i in range(count)],
                    [corners[4 * f + 1:4 * f + 4] for f in range(faces)])

    def write(self, path):
        lines = ["OFF", f"{len(self.vertices)} {len(self.faces)} 0"]
        lines += [" ".join(map(repr, p)) for p in self.vertices]
        lines += [f"3 {a} {b} {c}" for a, b, c in self.faces]
        path.write_text("\n".join(lines) + "\n")

    def scale(self):
        """The square root of the area."""
        return math.sqrt(sum(self._area(face) for face in self.faces))

    def _area(self, face):
        a, b, c = (self.vertices[v] for v in face)
        u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
        cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        return math.hypot(*cross) / 2

    def distances(self, start):
        """Lengths of shortest paths along edges from a vertex."""
        neighbours = collections.defaultdict(set)
        for face in self.faces:
            for v in face:
                neighbours[v].update(face)
        found, queue = {}, [(0.0, start)]
        while queue:
            distance, v = heapq.heappop(queue)
            if v in found:
                continue
            found[v] = distance
            for w in neighbours[v]:
                if w not in found:
                    heapq.heappush(queue, (distance + math.dist(self.vertices[v],
                                                                self.vertices[w]), w))
        return found

    def tips(self, count):
        """Extremities: always the vertex farthest along the surface from those before."""
        nearest = self.distances(self.faces[0][0])
        tips = []
        while len(tips) < count:
            tip = max(nearest, key=nearest.get)
            fresh = self.distances(tip)
            nearest = fresh if not tips else {v: min(d, fresh[v]) for v, d in nearest.items()}
            tips.append(tip)
        return tips

    def without_part(self, generator):
        """The mesh without what is near one of its tips, and the new number of each vertex that is
        left."""
        distances = self.distances(generator.choice(self.tips(4)))
        reach = generator.uniform(0.25, 0.4) * self.scale()
        faces = [f for f in self.faces if all(distances.get(v, 0) > reach for v in f)]
        kept = Mesh(self.vertices, faces).distances(max(distances, key=distances.get))
        faces = [f for f in faces if f[0] in kept]
        numbers = {v: i for i, v in enumerate(sorted({v for f in faces for v in f}))}
        return Mesh([self.vertices[v] for v in numbers],
                    [[numbers[v] for v in f] for f in faces]), numbers


def read_truth(pair):
    """Pairs of vertices from 0, as many as there are lines."""
    files = pair.truth[1:4:2]
    lists = [[int(line) - 1 for line in file.read_text().split()] for file in files]
    return [(s, t) for s, t in zip(*lists) if s >= 0 and t >= 0]


def cut_source(source, target, truth, generator):
    source, numbers = source.without_part(generator)
    return source, target, [(numbers[s], t) for s, t in truth if s in numbers], []


def cut_target(source, target, truth, generator):
    target, numbers = target.without_part(generator)
    return source, target, [(s, numbers[t]) for s, t in truth if t in numbers], []


def exchange(source, target, truth, generator):
    """Landmarks at the tips, of which two lead to each other's place."""
    places = []
    for tip in source.tips(5):
        near = min(truth, key=lambda pair: math.dist(source.vertices[pair[0]],
                                                     source.vertices[tip]))
        if near not in places:
            places.append(near)
    landmarks = [list(pair) for pair in places]
    first, second = generator.sample(range(len(landmarks)), 2)
    landmarks[first][1], landmarks[second][1] = landmarks[second][1], landmarks[first][1]
    return source, target, truth, landmarks


def of_pairs(kind, pairs, options=(), spoil=None):
    return [Case(kind, *pair.meshes, read_truth(pair), list(options), spoil) for pair in pairs]


def listed_pairs(folder, generator, count):
    pairs = [line.split() for line in (folder / "pairs.txt").read_text().splitlines()]
    return [data_sets.Pair(folder, ".off", *pair) for pair in generator.sample(pairs, count)]


def cases(data, seed):
    generator = random.Random(seed)
    tosca = [p for kind in data_sets.TOSCA_KINDS
             for p in data_sets.within(data / "tosca5k", kind)]
    sets = {name: data_sets.within(data / name) for name in
            ("faust5k", "horse_gallop", "jumping_man", "elephant42k", "tosca_cat28k")}
    sets["tosca5k"] = tosca

    def some(name, count):
        return generator.sample(sorted(sets[name]), count)

    def people_and_animals(people, animals):
        return some("faust5k", people) + some("tosca5k", animals)

    right = [("faust5k", 16), ("tosca5k", 20), ("horse_gallop", 6), ("jumping_man", 4),
             ("elephant42k", 2), ("tosca_cat28k", 2)]
    chosen = [case for name, count in right for case in of_pairs(name, some(name, count))]
    chosen += of_pairs("smal5k", listed_pairs(data / "smal5k", generator, 10))
    spoilt = [("limb exchanged", [], exchange, 6, 8), ("part of the source cut off", [], cut_source,
               4, 4), ("part of the target cut off", [], cut_target, 4, 4),
              ("paper's method", ["--method", "paper"], None, 4, 6)]
    for kind, options, spoil, people, animals in spoilt:
        chosen += of_pairs(kind, people_and_animals(people, animals), options, spoil)
    chosen += of_pairs("wrong hypothesis", people_and_animals(5, 5), ["--alternatives", "1"])
    people = [p.meshes[0] for p in some("faust5k", 6)]
    animals = [p.meshes[0] for p in some("tosca5k", 6)]
    for person, animal in zip(people, animals):
        chosen += [Case("other species", person, animal, None, [], None),
                   Case("other species", animal, person, None, [], None)]
    horses = sorted((data / "tosca5k").glob("horse*.off"))
    for source in sorted((data / "horse_gallop").glob("*.ply"))[::6]:
        chosen += [Case("gallop to TOSCA's horses", source, target, None, [], None)
                   for target in horses[:4]]
    return chosen


def share_off(folder, target, truth):
    """Share of the points of the truth whose image is off, straight through space, and the mean of
    all, x100 over sqrt(area)."""
    lines = [line.split() for line in (folder / "source_to_target.bary.txt").read_text().split("\n")
             if line] if (folder / "source_to_target.bary.txt").exists() else None
    images = lines or [[v] for v in (folder / "source_to_target.txt").read_text().split()]

    def place(image):
        if len(image) == 1:
            return target.vertices[int(image[0])]
        corners = [target.vertices[v] for v in target.faces[int(image[0])]]
        return [sum(float(w) * c[k] for w, c in zip(image[1:], corners)) for k in range(3)]

    scale = target.scale()
    errors = [math.dist(place(images[s]), target.vertices[t]) / scale
              for s, t in truth if int(images[s][0]) >= 0]
    return sum(e > OFF for e in errors) / len(errors), 100 * sum(errors) / len(errors)


def label(case, off):
    if case.kind.startswith("part of") or case.kind == "other species":
        return "wrong"
    if off is None:
        return "wrong by eye"
    return "right" if off < RIGHT else "wrong" if off > WRONG else "between"


def measure(case, number, arguments, threads):
    """A row for each map."""
    generator = random.Random(number)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        source = Mesh.load(arguments.program, case.source, folder)
        target = Mesh.load(arguments.program, case.target, folder)
        truth, options = case.truth, list(case.options)
        if case.spoil:
            source, target, truth, landmarks = case.spoil(source, target, truth, generator)
            if landmarks:
                file = folder / "landmarks.txt"
                file.write_text("".join(f"{s} {t}\n" for s, t in landmarks))
                options += ["--landmarks", file]
        source.write(folder / "source.off")
        target.write(folder / "target.off")
        run([arguments.program, "match", folder / "source.off", folder / "target.off", "-o",
             folder / "out", "--quiet", "--threads", threads, *options])
        report = json.loads((folder / "out/report.json").read_text())
        results = [(folder / "out", report["fit"])]
        results += [(folder / "out" / other["folder"], other["fit"])
                    for other in report.get("alternatives", [])]
        rows = []
        for place, fit in results:
            off, error = share_off(place, target, truth) if truth else (None, None)
            rows.append({"kind": case.kind, "pair": case.name, "label": label(case, off),
                         "error": error, "off": off, **fit})
        return rows


def measure_all(arguments):
    chosen = cases(arguments.data, arguments.seed)
    threads = max(1, (os.cpu_count() or 1) // arguments.jobs)

    def rows(numbered):
        number, case = numbered
        try:
            result = measure(case, number, arguments, threads)
        except ProgramFailed as error:
            print(f"{case.kind}: {case.name}: {error}", file=sys.stderr, flush=True)
            return []
        for row in result:
            print(f"{number}/{len(chosen)} {row['kind']}: {row['pair']}: {row['label']}, called "
                  f"{row['grade']}", file=sys.stderr, flush=True)
        return result

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        return [row for result in pool.map(rows, enumerate(chosen)) for row in result]


def count_table(rows, key):
    lines = table_head([key, *GRADES, "not good"])
    for value in dict.fromkeys(row[key] for row in rows):
        grades = [row["grade"] for row in rows if row[key] == value]
        share = sum(grade != "good" for grade in grades) / len(grades)
        lines.append(table_line([value, *map(grades.count, GRADES), f"{100 * share:.0f} %"]))
    return "\n".join(lines)


MEASURES = ("stretch", "distorted", "displacement", "relief", "unreached", "reversed")


def pair_line(row):
    error = "" if row["error"] is None else f"{row['error']:.2f}"
    off = "" if row["off"] is None else f"{100 * row['off']:.1f}"
    figures = ["" if row[m] is None else f"{row[m]:.3f}" for m in MEASURES]
    return table_line([row["kind"], row["pair"], error, off, row["label"], row["grade"], *figures])


HEADER = """# The verdict on the fit

Made by `bench/tables/verdict.py` at commit {commit} on {machine}, seed {seed}. The limits were
calibrated with some 130 maps of the same sets, most of them of other pairs.

A map is *right* if less than 1 % of the points of the ground truth land more than .1 sqrt(area) from
where they belong, *wrong* if more than 3 % do, and *between* otherwise. Where a part is cut off or
the species differs, some of the map is wrong in any case. The horses of the gallop go to TOSCA's
with the tail along the back, by eye.

{labels}

By kind of pair:

{kinds}

## Pairs

The error is x100 over sqrt(area), straight through space; *off* the share of points beyond .1, in
percent.

{pairs}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "verdict.md")
    add_data_argument(parser)
    parser.add_argument("--jobs", type=int, default=1, help="matches at a time")
    parser.add_argument("--seed", type=int, default=1, help="of the choice of pairs")
    arguments = parser.parse_args()
    rows = measure_all(arguments)
    columns = ["kind", "pair", "error", "off", "label", "verdict", *MEASURES]
    text = HEADER.format(commit=commit(), machine=machine(), seed=arguments.seed,
                         labels=count_table(rows, "label"), kinds=count_table(rows, "kind"),
                         pairs="\n".join(table_head(columns) + [pair_line(r) for r in rows]))
    write_page(arguments.out, text)
    print(text.split("## Pairs")[0])


if __name__ == "__main__":
    main()
