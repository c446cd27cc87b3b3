#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What landmarks do to maps of the tracked method, as a table in docs/results/landmarks.md.

True ones, drawn from the ground truth, must not make a map worse. False ones, of which one in a set
leads to the true place of another vertex at least a quarter of sqrt(area) away, must be named.
Usage: bench/tables/landmarks.py [--pairs 10] [--sets 5]
"""

import argparse
import json
import math
import pathlib
import random
import sys
import tempfile

import data_sets
from common import (add_common_arguments, add_data_argument, commit, evaluate, machine, run,
                    table_head, table_line, write_page)

SIZES = (1, 3, 6)
WORSE = 1.1  # Times the error without landmarks, above which a set counts as harmful.
FAR = 0.25  # Of a false landmark from the true place, over sqrt(area).


def pairs_of(data):
    """Ten pairs of every kind."""
    known = data_sets.pairs_with_truth(data)
    kinds = {"faust5k": 3, "tosca5k": 4, "horse_gallop": 2, "jumping_man": 1}
    return [pair for kind, count in kinds.items() for pair in known[kind][:count]]


def read_truth(pair):
    """Vertices from 0 of template points on both shapes."""
    lists = [[int(line) - 1 for line in path.read_text().split()] for path in pair.truth[1::2][:2]]
    return list(zip(*lists))


def match(program, pair, landmarks):
    """The error of the map's points, x100, the energy, and what was said of the landmarks."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        options = []
        if landmarks:
            file = folder / "landmarks.txt"
            file.write_text("".join(f"{s} {t}\n" for s, t in landmarks))
            options = ["--landmarks", file]
        run([program, "match", *pair.meshes, "-o", folder / "out", "--quiet", *options])
        report = json.loads((folder / "out/report.json").read_text())
        evaluation = evaluate(program, *pair.meshes, folder / "out/source_to_target.bary.txt",
                              pair.truth)
    error = 100 * evaluation["ground_truth"]["point_error_over_sqrt_area"]["mean"]
    return error, report["map"]["energy"], report["contradicted_landmarks"]


def positions(program, mesh):
    """Vertices, and the square root of the area."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "mesh.off"
        run([program, "convert", mesh, file])
        words = file.read_text().split()
    count = int(words[1])
    area = json.loads(run([program, "info", mesh, "--json"]))["area"]
    numbers = [float(word) for word in words[4:4 + 3 * count]]
    return [numbers[3 * i:3 * i + 3] for i in range(count)], math.sqrt(area)


def spoil(landmarks, truth, target, generator):
    """`landmarks` with one that leads to the true place of another vertex, and which it is."""
    places, scale = target
    wrong = generator.randrange(len(landmarks))
    source, right = landmarks[wrong]
    while True:
        other = generator.choice(truth)[1]
        if math.dist(places[other], places[right]) > FAR * scale:
            break
    spoilt = list(landmarks)
    spoilt[wrong] = (source, other)
    return spoilt, wrong


def listed(landmarks):
    return ", ".join(f"{s} {t}" for s, t in landmarks)


def measure_true(arguments, pairs):
    rows = []
    for number, pair in enumerate(pairs):
        truth = read_truth(pair)
        free, free_energy, _ = match(arguments.program, pair, [])
        generator = random.Random(number)
        for k in range(arguments.sets):
            landmarks = generator.sample(truth, SIZES[k % len(SIZES)])
            error, energy, contradicted = match(arguments.program, pair, landmarks)
            rows.append([pair.name, len(landmarks), f"{free:.2f}", f"{error:.2f}",
                         f"{free_energy:.4f}", f"{energy:.4f}",
                         "worse" if error > WORSE * free else "",
                         listed(contradicted)])
            print(*rows[-1], sep="  ", file=sys.stderr, flush=True)
    return rows


def measure_false(arguments, pairs):
    rows = []
    for number, pair in enumerate(pairs):
        truth = read_truth(pair)
        generator = random.Random(1000 + number)
        target = positions(arguments.program, pair.meshes[1])
        for size in SIZES[1:]:
            landmarks, wrong = spoil(generator.sample(truth, size), truth, target, generator)
            error, energy, contradicted = match(arguments.program, pair, landmarks)
            false = list(landmarks[wrong])
            outcome = ("named" if contradicted == [false] else
                       "named with others" if false in contradicted else "missed")
            rows.append([pair.name, size, f"{error:.2f}", f"{energy:.4f}", listed([false]),
                         listed(contradicted), outcome])
            print(*rows[-1], sep="  ", file=sys.stderr, flush=True)
    return rows


HEADER = """# Landmarks

Made by `bench/tables/landmarks.py` at commit {commit} on {machine}. Errors are x100 over sqrt(area),
as in [tracked.md](tracked.md). Landmarks are drawn from the ground truth of nearest vertices, which
is itself off by up to half an edge.

## True landmarks

{worse} of {sets} sets made the map worse by more than a tenth, and in {suspected} of them a landmark
was called contradictory.

{table}

## One false landmark

It leads at least {far} sqrt(area) away from where it should. It was named in {named} of {false_sets}
sets, in {alone} of them alone.

{false_table}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser, "landmarks.md")
    add_data_argument(parser)
    parser.add_argument("--pairs", type=int, default=10)
    parser.add_argument("--sets", type=int, default=5, help="of true landmarks, for each pair")
    arguments = parser.parse_args()
    pairs = pairs_of(arguments.data)[:arguments.pairs]
    true_rows, false_rows = measure_true(arguments, pairs), measure_false(arguments, pairs)
    text = HEADER.format(
        commit=commit(), machine=machine(), sets=len(true_rows), far=FAR,
        worse=sum(row[-2] == "worse" for row in true_rows),
        suspected=sum(row[-1] != "" for row in true_rows),
        named=sum(row[-1] != "missed" for row in false_rows), false_sets=len(false_rows),
        alone=sum(row[-1] == "named" for row in false_rows),
        table="\n".join(table_head(["pair", "landmarks", "error without", "error", "energy without",
                                    "energy", "", "contradicted"]) +
                        [table_line(row) for row in true_rows]),
        false_table="\n".join(table_head(["pair", "landmarks", "error", "energy", "false one",
                                          "contradicted", ""]) +
                              [table_line(row) for row in false_rows]))
    write_page(arguments.out, text)
    print(text.split("\n| ")[0])


if __name__ == "__main__":
    main()
