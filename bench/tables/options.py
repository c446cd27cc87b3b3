#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What each number of the tracked method does, as a table in docs/results/options.md.

One number at a time is halved and doubled, the others stay; the mean error and the time are those
over the same pairs of shapes. What was measured by the same program on the same pairs is kept in
options.csv beside the page, and not measured again.

Usage: bench/tables/options.py [--every 3] [--only NAME]
"""

import argparse
import csv
import hashlib
import pathlib
import subprocess
import tempfile

import data_sets
from common import (ROOT, add_data_argument, commit, machine, mean, run, table_head, table_line,
                    write_csv, write_page)

SETS = ("faust5k", "tosca5k", "horse_gallop", "jumping_man")
#: They play a part only where there are landmarks, mirror images or finer meshes.
LEFT_OUT = ("landmark_slack", "contradiction", "landmark_reach", "mirror_price",
            "pyramid.detail_vertices")
COLUMNS = ("program", "number", "value", "mean_error", "failures", "worst", "seconds")
#: Changes of the mean error, x100, that the choice of pairs may make by itself.
NOISE = 0.02


def chosen_pairs(data, every):
    """Every so manyth of the development pairs."""
    known = data_sets.pairs_with_truth(data)
    return [pair for name in SETS for pair in known[name][::every]]


class Ablation:
    """The running program, with its pairs in memory."""

    def __init__(self, program, pairs):
        self.program = program
        text = "".join(
            " ".join(str(path) for path in [*pair.meshes, pair.truth[1], pair.truth[3]]) + "\n"
            for pair in pairs)
        self.key = hashlib.sha256(program.read_bytes() + text.encode()).hexdigest()[:12]
        self.file = tempfile.NamedTemporaryFile("w", suffix=".txt")
        self.file.write(text)
        self.file.flush()
        self.process = None

    def numbers(self):
        lines = run([self.program]).splitlines()
        return {name: float(value) for name, value in (line.split() for line in lines)}

    def measure(self, name, value):
        """Errors of the pairs and the seconds that all took."""
        if self.process is None:
            self.process = subprocess.Popen([str(self.program), self.file.name], text=True,
                                            stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.process.stdin.write(f"{name} {value:g}\n" if name else "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline().split()
        if not answer:
            self.process = None
            return None
        return [float(word) for word in answer[:-1]], float(answer[-1])


def read_known(path, key):
    if not path.exists():
        return {}
    with path.open(newline="") as file:
        return {(row["number"], row["value"]): row for row in csv.DictReader(file)
                if row["program"] == key}


def figures(key, name, value, answer):
    errors, seconds = answer if answer else ([], 0.0)
    found = [error for error in errors if error >= 0]
    return dict(zip(COLUMNS, (key, name, value, f"{mean(found):.3f}", len(errors) - len(found),
                              f"{max(found, default=float('nan')):.2f}", f"{seconds:.1f}")))


def settings(numbers, only):
    yield "", ""
    for name, value in numbers.items():
        if name in LEFT_OUT or not name.startswith(only):
            continue
        is_integer = value == int(value) and value >= 1
        for factor in (0.5, 2):
            changed = value * factor
            if is_integer:
                changed = int(changed)
            if changed != value:
                yield name, f"{changed:g}"


def measured(ablation, numbers, only, path):
    known = read_known(path, ablation.key)
    rows = []
    for name, value in settings(numbers, only):
        row = known.get((name, value))
        if row is None:
            answer = ablation.measure(name, float(value) if value else 0)
            row = figures(ablation.key, name, value, answer)
        rows.append(row)
        write_csv(path, COLUMNS, [[row[column] for column in COLUMNS] for row in rows])
        print(name, value, row["mean_error"], row["seconds"], flush=True)
    return rows


def cell(row, base):
    if row is None:
        return ["", "", ""]
    error = float(row["mean_error"]) - float(base["mean_error"])
    lost = f", {row['failures']} without a map" if int(row["failures"]) else ""
    if error != error:
        return [row["value"], "refused", ""]
    shown = f"{error:+.2f}" if abs(error) >= NOISE else "0"
    ratio = float(row["seconds"]) / float(base["seconds"])
    return [row["value"], shown + lost, f"{ratio:.2f}"]


def page(rows, numbers, pairs):
    base = rows[0]
    by_name = {}
    for row in rows[1:]:
        by_name.setdefault(row["number"], []).append(row)
    lines = [
        "# What the numbers of the tracked method do", "",
        f"One number is halved or doubled at a time. Over {len(pairs)} pairs of shapes of "
        f"{', '.join(SETS)} the mean error is {float(base['mean_error']):.2f} (points on triangles, "
        f"x100 over sqrt(area)) with all numbers as they are, and the worst "
        f"{float(base['worst']):.1f}; the columns have the change of the mean, 0 where it is less "
        f"than {NOISE}, and the time as a ratio. What the numbers mean stands in "
        "[options.h](../../src/tracked/options.h).", "",
        *table_head(["number", "default", "halved", "error", "time", "doubled", "error", "time"])]
    for name, found in by_name.items():
        halved = next((row for row in found if float(row["value"]) < numbers[name]), None)
        doubled = next((row for row in found if float(row["value"]) > numbers[name]), None)
        lines.append(table_line([f"`{name}`", f"{numbers[name]:g}", *cell(halved, base),
                                 *cell(doubled, base)]))
    lines += ["", f"Measured on {machine()}, commit {commit()}, by `bench/tables/options.py`.", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path,
                        default=ROOT / "build/dev/bench/ablation/isomatch-ablation")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/results/options.md")
    parser.add_argument("--every", type=int, default=3, help="use every so manyth pair")
    parser.add_argument("--only", default="", help="only numbers whose names begin like this")
    add_data_argument(parser)
    arguments = parser.parse_args()
    pairs = chosen_pairs(arguments.data, arguments.every)
    ablation = Ablation(arguments.program, pairs)
    numbers = ablation.numbers()
    rows = measured(ablation, numbers, arguments.only, arguments.out.with_suffix(".csv"))
    write_page(arguments.out, page(rows, numbers, pairs))


main()
