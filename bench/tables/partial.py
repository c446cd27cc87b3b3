#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Matching of pieces, of shapes with fused parts and of rigid ones, in docs/results/partial.md.

Turns and shifts every shape by itself, runs `isomatch match` on every pair, and compares with the
truth. A run that is cut down writes a page only if --out says where.
Usage: bench/tables/partial.py [--sets partial_cuts,skulls] [--every 4] [--jobs 2] [-- OPTIONS]
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import sys
import tempfile
import time

import partial_page
from common import (ROOT, ProgramFailed, add_common_arguments, add_data_argument, run, write_page)
from partial_scores import landmark_scores, read_map, read_report, scores, true_map
from partial_sets import DRAWN, LISTED, all_pairs, reference_area, truth_of, turned_file
from rigid import rigid_map
from surfaces import Distances, read_surface

PAGE = ROOT / "docs/results/partial.md"
SETS = (*LISTED, *DRAWN)
TURNED = pathlib.Path(tempfile.gettempdir()) / "isomatch-turned"


def score(pair, source, target, found_in):
    """The figures of the map that `found_in(truth)` gives."""
    truth = truth_of(pair, len(source.vertices))
    found = found_in(truth)
    distances = Distances(target)
    if pair.set == "skulls":
        return landmark_scores(truth, found, target, distances)
    return scores(truth, found, source, target, reference_area(pair, source, target), distances)


def matched(arguments, pair, meshes, folder):
    """The figures of the program's result, which it leaves in `folder`."""
    start = time.perf_counter()
    run([arguments.program, "match", *meshes, "-o", folder, "--quiet",
         "--threads", arguments.threads, *arguments.options])
    seconds = time.perf_counter() - start
    source, target = map(read_surface, meshes)
    figures = score(pair, source, target, lambda _: read_map(folder, target))
    return {**figures, **read_report(folder), "seconds": seconds}


def matched_and_kept(arguments, pair, meshes):
    if arguments.keep:
        return matched(arguments, pair, meshes, arguments.keep / pair.set / pair.name)
    with tempfile.TemporaryDirectory() as folder:
        return matched(arguments, pair, meshes, pathlib.Path(folder))


def figures_of_truth(pair, meshes):
    """Those of the truth as a map, which should be perfect."""
    source, target = map(read_surface, meshes)
    figures = score(pair, source, target, lambda truth: true_map(truth, source, target))
    return {**figures, "seconds": 0}


def rigid_figures(pair, meshes):
    """Those of the nearest vertices after a rigid alignment."""
    source, target = map(read_surface, meshes)
    start = time.perf_counter()
    found = rigid_map(source, target)
    seconds = time.perf_counter() - start
    return {**score(pair, source, target, lambda _: found), "seconds": seconds}


def outcome(arguments, pair):
    """All that is known of a pair, `failure` instead of figures if the program ended with one."""
    row = {"set": pair.set, "group": pair.group, "source": pair.source, "target": pair.target,
           "name": pair.name}
    meshes = [turned_file(pair, name, arguments.turned) for name in (pair.source, pair.target)]
    try:
        row.update(figures_of_truth(pair, meshes) if arguments.truth else
                   matched_and_kept(arguments, pair, meshes))
    except ProgramFailed as error:
        row["failure"] = str(error).splitlines()[-1]
    if arguments.rigid and pair.set == "skulls":
        row["rigid"] = rigid_figures(pair, meshes)
    print(f"{pair.set}: {partial_page.line(row)}", file=sys.stderr, flush=True)
    return row


def chosen_pairs(arguments, title):
    pairs = all_pairs(arguments.data, title)
    if arguments.pairs:
        wanted = arguments.pairs.split(",")
        pairs = [pair for pair in pairs if any(part in pair.name for part in wanted)]
    return pairs[arguments.offset::arguments.every]


def measure(arguments):
    pairs = [pair for title in arguments.sets for pair in chosen_pairs(arguments, title)]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        return list(pool.map(lambda pair: outcome(arguments, pair), pairs))


def parse_arguments(words):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser)
    add_data_argument(parser)
    parser.add_argument("--sets", help="names of sets, separated by commas; else all")
    parser.add_argument("--every", type=int, default=1, help="only every Nth pair of a set")
    parser.add_argument("--offset", type=int, default=0, help="the number of the first, from 0")
    parser.add_argument("--pairs", help="only pairs A__B with one of these, separated by commas, "
                        "in their name")
    parser.add_argument("--jobs", type=int, default=1, help="matches at a time")
    parser.add_argument("--turned", type=pathlib.Path, default=TURNED,
                        help="where turned shapes are kept")
    parser.add_argument("--keep", type=pathlib.Path, help="keep results, as SET/A__B in here")
    parser.add_argument("--json", type=pathlib.Path, help="write the figures of each pair")
    parser.add_argument("--compare", type=pathlib.Path,
                        help="print what changed since the run whose figures are in this file")
    parser.add_argument("--rigid", action="store_true",
                        help="align skulls rigidly as well, to compare with; always for the page")
    parser.add_argument("--truth", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args(words)
    arguments.is_whole = not (arguments.sets or arguments.pairs or arguments.truth or
                              arguments.every > 1 or arguments.offset)
    arguments.rigid |= arguments.is_whole
    arguments.sets = arguments.sets.split(",") if arguments.sets else SETS
    arguments.threads = max(1, (os.cpu_count() or 1) // arguments.jobs)
    for title in arguments.sets:
        if title not in SETS:
            parser.error(f"there is no set {title}: {', '.join(SETS)}")
    return arguments


def main():
    words = sys.argv[1:]
    end = words.index("--") if "--" in words else len(words)
    arguments = parse_arguments(words[:end])
    arguments.options = words[end + 1:]
    rows = measure(arguments)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n")
    path = arguments.out
    if not path and arguments.is_whole and not arguments.options:
        path = PAGE
    picture = path and partial_page.calibration(rows) and path.with_suffix(".svg")
    text = partial_page.page(arguments, rows, picture and picture.name)
    print(partial_page.without_pairs(text))
    if arguments.compare:
        print(partial_page.comparison(rows, json.loads(arguments.compare.read_text())))
    if picture:
        partial_page.plot_calibration(rows, picture)
    if path:
        write_page(path, text)


if __name__ == "__main__":
    main()
