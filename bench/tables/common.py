# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What the tables share: running the program, evaluating a map, statistics, where and on what."""

import csv
import functools
import json
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


class ProgramFailed(Exception):
    """A command that ended with an error, which is the message."""


def run(command):
    """What `command` prints."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise ProgramFailed(done.stderr.strip() or f"{command[0]} ended with {done.returncode}")
    return done.stdout


def add_common_arguments(parser, page=None):
    """`page` is the default of --out, in the folder of results."""
    parser.add_argument("--program", type=pathlib.Path,
                        default=ROOT / "build/release/tools/isomatch")
    parser.add_argument("--out", type=pathlib.Path, default=page and ROOT / "docs/results" / page)


def add_data_argument(parser):
    parser.add_argument("--data", type=pathlib.Path, default=ROOT / "../shared/data")


def truth_options(folder, source, target):
    """The options of `isomatch eval` for the ground truth between two shapes of a data set."""
    truth = folder / "corres"
    options = ["--gt-source", truth / f"{source}.vts", "--gt-target", truth / f"{target}.vts"]
    symmetric = truth / f"{target}.sym.vts"
    if symmetric.exists():
        options += ["--gt-target-sym", symmetric]
    return options


def evaluate(program, source, target, result, options=()):
    """What `isomatch eval` says of the map in the file `result` between two mesh files."""
    return json.loads(run([program, "eval", source, target, result, "--json", *options]))


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else float("nan")


def percentile(values, share):
    """Interpolates between neighbours in order."""
    values = sorted(values)
    if not values:
        return float("nan")
    place = share * (len(values) - 1)
    low = int(place)
    high = min(low + 1, len(values) - 1)
    return values[low] + (place - low) * (values[high] - values[low])


def table_line(cells):
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def table_head(columns):
    return [table_line(columns), "|" + "---|" * len(columns)]


def write_page(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def write_csv(path, columns, rows):
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)


def machine():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    models = [line.split(":")[1].strip() for line in lines if line.startswith("model name")]
    return f"{len(models)} cores, {models[0] if models else 'unknown processor'}"


@functools.cache
def commit():
    """As it is when first asked for: pages that are written later make the folder dirty."""
    return run(["git", "-C", ROOT, "describe", "--always", "--dirty"]).strip()
