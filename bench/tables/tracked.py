#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Accuracy and time of the tracked method on the data sets, as a table in docs/results/tracked.md.

Runs `isomatch match` and `isomatch eval` on every pair. A run that is cut down by --sets or --pairs
writes a page only if --out says where.
Usage: bench/tables/tracked.py [--sets faust5k,tosca5k] [--pairs 10] [--ablations] [--jobs 2]
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import sys
import tempfile
import time

import data_sets
from common import (ROOT, ProgramFailed, add_common_arguments, add_data_argument, commit, evaluate,
                    machine, mean, percentile, run, table_head, table_line, write_page)

PAGE = ROOT / "docs/results/tracked.md"
GROSS = 10  # Mean error, x100 over sqrt(area), above which a map is wrong as a whole.
VARIANTS = {"without orientation": ["--no-orientation"],
            "without elastic judging": ["--no-elastic-judging"],
            "without refinement": ["--no-refinement"]}
ABLATED_SETS = "faust5k,tosca5k"


class Figures:
    """What was measured on one pair."""

    def __init__(self, pair, seconds, report, evaluation, exact=None, perfect=None):
        """`exact` is the error from the exact truth, `perfect` that of the exact map, if known."""
        self.pair, self.seconds, self.report = pair, seconds, report
        self.exact, self.perfect = exact, perfect
        self.d_iso = evaluation["d_iso_over_max_geodesic"]
        self.orientation = evaluation["orientation"]["verdict"]
        self.registered = evaluation["registered"]
        self.flipped = evaluation.get("flipped", self.orientation == "reverses")
        self.has_truth = "ground_truth" in evaluation
        if self.has_truth:
            self.vertices, self.points = (
                100 * evaluation["ground_truth"][f"{kind}_over_sqrt_area"]["mean"]
                for kind in ("error", "point_error"))

    @property
    def unsound(self):
        """Triangles of the registered source at folds or squeezed, in %."""
        return 100 * (self.registered["folded"] + self.registered["squeezed"])

    @property
    def reach(self):
        """Of the target's area what the registered source reaches, in %."""
        return 100 * self.registered["reach"]

    @property
    def wrong(self):
        return self.has_truth and not self.flipped and self.points > GROSS

    @property
    def cells(self):
        errors = [f"{self.vertices:.2f}", f"{self.points:.2f}"] if self.has_truth else []
        errors += [f"{self.exact:.2f}"] if self.exact is not None else []
        outcome = "flipped" if self.flipped else "wrong" if self.wrong else self.orientation
        return [self.pair.name, *errors, f"{self.d_iso['mean']:.4f}", outcome,
                f"{self.unsound:.2f}", f"{self.reach:.1f}", f"{self.report['ambiguity']:.2f}", f"{self.seconds:.2f}"]


class Failure:
    """A pair that the program refused, and why."""

    def __init__(self, pair, reason):
        self.pair, self.reason = pair, str(reason).splitlines()[-1]

    @property
    def cells(self):
        return [self.pair.name, self.reason]


class Results:
    """What was measured on the pairs of a set."""

    def __init__(self, outcomes):
        self.figures = [outcome for outcome in outcomes if isinstance(outcome, Figures)]
        self.failures = [outcome for outcome in outcomes if isinstance(outcome, Failure)]
        self.pairs = len(outcomes)
        self.has_truth = any(f.has_truth for f in self.figures)
        self.exact = [f for f in self.figures if f.exact is not None]

    def median(self, figure):
        return percentile([figure(f) for f in self.figures], 0.5)

    def median_seconds(self):
        return f"{self.median(lambda f: f.seconds):.2f}"


def exact_figures(program, pair, result, folder):
    """The mean error of a map from the exact truth, and that of the exact truth from the usual one,
    if the set has an exact truth."""
    truth = folder / "truth.bary.txt"
    if not pair.write_exact_map(truth):
        return None, None
    found = evaluate(program, *pair.meshes, result, ["--gt-map", truth])["ground_truth_map"]
    perfect = evaluate(program, *pair.meshes, truth, pair.truth)["ground_truth"]
    return (100 * found["point_error_over_sqrt_area"]["mean"],
            100 * perfect["error_over_sqrt_area"]["mean"])


def match(program, pair, has_truth, options):
    with tempfile.TemporaryDirectory() as out:
        start = time.perf_counter()
        run([program, "match", *pair.meshes, "-o", out, "--quiet", *options])
        seconds = time.perf_counter() - start
        out = pathlib.Path(out)
        surface = ["--registered", out / "registered.ply"]
        report = json.loads((out / "report.json").read_text())
        if not has_truth:
            return Figures(pair, seconds, report,
                           evaluate(program, *pair.meshes, out / "correspondence.txt", surface))
        result = out / "source_to_target.bary.txt"
        evaluation = evaluate(program, *pair.meshes, result, [*pair.truth, *surface])
        return Figures(pair, seconds, report, evaluation,
                       *exact_figures(program, pair, result, out))


def threads(arguments):
    """Threads of each match."""
    return max(1, (os.cpu_count() or 1) // arguments.jobs)


def measure(arguments, title, pairs, has_truth, options=()):
    def outcome(pair):
        try:
            result = match(arguments.program, pair, has_truth,
                           ["--threads", threads(arguments), *options])
        except ProgramFailed as error:
            result = Failure(pair, error)
        print(f"{title}: {'  '.join(result.cells)}", file=sys.stderr, flush=True)
        return result

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        return Results(list(pool.map(outcome, pairs[:arguments.pairs])))


ACCURACY_COLUMNS = ["pairs", "mean", "median", "95 %", "points: mean", "median", "95 %",
                    "worst pair", "exact truth: mean", "median", "worst pair", "perfect map",
                    "flipped", "wrong", "folded or squeezed %", "reach %", "failed", "seconds"]


def surface_cells(results):
    return [f"{mean(f.unsound for f in results.figures):.2f}",
            f"{mean(f.reach for f in results.figures):.1f}"]


def accuracy_cells(results):
    def distribution(errors):
        return [f"{value:.2f}" for value in
                (mean(errors), percentile(errors, 0.5), percentile(errors, 0.95))]

    def worst(figures, error):
        figure = max(figures, key=error, default=None)
        return f"{figure.pair.name}: {error(figure):.2f}" if figure else ""

    exact = ["", "", "", ""]
    if results.exact:
        exact = [f"{mean(f.exact for f in results.exact):.2f}",
                 f"{percentile([f.exact for f in results.exact], 0.5):.2f}",
                 worst(results.exact, lambda f: f.exact),
                 f"{mean(f.perfect for f in results.exact):.2f}"]
    return [results.pairs, *distribution([f.vertices for f in results.figures]),
            *distribution([f.points for f in results.figures]),
            worst(results.figures, lambda f: f.points), *exact,
            sum(f.flipped for f in results.figures), sum(f.wrong for f in results.figures),
            *surface_cells(results), len(results.failures), results.median_seconds()]


def cross_cells(results):
    means = [f.d_iso["mean"] for f in results.figures]
    verdicts = [f.orientation for f in results.figures]
    return [results.pairs, f"{mean(means):.4f}", f"{max(means, default=0):.4f}",
            f"{mean(f.d_iso['maximum'] for f in results.figures):.4f}",
            verdicts.count("preserves"), verdicts.count("reverses"),
            *surface_cells(results), len(results.failures), results.median_seconds()]


CROSS_COLUMNS = ["pairs", "D_iso", "largest D_iso", "d_iso†", "orientation preserved", "reversed",
                 "folded or squeezed %", "reach %", "failed", "seconds"]


def table(first_columns, columns, cells, all_results):
    """A line of `cells` for each set; its key gives the first columns."""
    return "\n".join(table_head([*first_columns, *columns]) +
                     [table_line([*key, *cells(results)]) for key, results in all_results.items()])


def time_table(all_results):
    reports = [f.report for results in all_results.values() for f in results.figures]
    stages = list(dict.fromkeys(stage for report in reports for stage in report["seconds"]))

    def cells(results):
        return [f"{results.median(lambda f: f.report['source']['vertices']):.0f}",
                *(f"{results.median(lambda f: f.report['seconds'].get(stage, 0)):.2f}"
                  for stage in stages),
                results.median_seconds(),
                f"{results.median(lambda f: f.report['peak_memory_mib']):.0f}"]

    columns = ["vertices", *stages, "whole program", "peak MiB"]
    return table(["data"], columns, cells, all_results)


def pairs_section(title, results):
    errors = ["error", "points"] if results.has_truth else []
    errors += ["exact"] if results.exact else []
    lines = ["", f"### {title}", ""]
    lines += table_head(["pair", *errors, "D_iso", "map", "folded or squeezed %", "reach %",
                         "ambiguity", "seconds"])
    lines += [table_line(f.cells) for f in results.figures]
    for failure in results.failures:
        lines += ["", ": ".join(failure.cells)]
    return "\n".join(lines)


HEADER = """# The tracked method on real shapes

Made by `bench/tables/tracked.py` at commit {commit} on {machine}; {jobs} at a time, of {threads}
threads. Pairs are drawn with seed 0 from all ordered pairs of a set, in tosca5k of one class.

Errors are geodesic distances of a pair's map from the ground truth, x100 over sqrt(area) of the
target, averaged over the pair; the table has their mean, median and 95th percentile over the pairs,
first of the nearest vertices, then of the map to points on triangles. That truth of remeshed shapes
is a vertex that is nearest on both sides; the *exact truth* is a point on a triangle (see the README
of the data), from which the map's points are as far as it says, and the *perfect map* is what the
exact truth itself scores by the usual one, as nearest vertices. *Flipped* maps are nearer to
the left-right symmetric truth than to the true one; where none is known, they reverse orientation.
*Wrong* maps are not flipped and have an error above {gross}. Means include both, but not pairs that
*failed*. Of the registered source, the share of triangles that are *folded or squeezed*, and of the
target's area that it *reaches*, are defined in [metrics.md](../metrics.md), means over the pairs.
Seconds are the median wall time of the whole program, with reading and writing.

"""

CROSS_TEXT = """

## Across classes

There is no dense ground truth. D_iso and d_iso† (maximum over a pair) are those of the many-to-many
result, over the largest geodesic distance. The paper reports .036 and .055 for Dog-Wolf, .037 and
.066 for Wolf-Horse.

"""


def page(arguments, all_results, ablations):
    known = {key: results for key, results in all_results.items() if results.has_truth}
    across = {key: results for key, results in all_results.items() if not results.has_truth}
    text = HEADER.format(commit=commit(), machine=machine(), jobs=arguments.jobs,
                         threads=threads(arguments), gross=GROSS)
    if known:
        text += table(["data"], ACCURACY_COLUMNS, accuracy_cells, known)
    if across:
        text += CROSS_TEXT + table(["data"], CROSS_COLUMNS, cross_cells, across)
    if ablations:
        text += "\n\n## Ablations\n\n"
        text += table(["data", "variant"], ACCURACY_COLUMNS, accuracy_cells, ablations)
    text += "\n\n## Time\n\nMedian seconds of each stage.\n\n" + time_table(all_results)
    text += "\n\n## Pairs\n" + "\n".join(pairs_section(*key, r) for key, r in all_results.items())
    return text + "\n"


def measure_ablations(arguments, known, all_results):
    """Each variant on each set that is ablated, after the complete method."""
    ablations = {}
    for title in (arguments.ablations or "").split(","):
        if (title,) not in all_results:
            continue
        ablations[title, "complete"] = all_results[title,]
        for variant, options in VARIANTS.items():
            ablations[title, variant] = measure(arguments, f"{title} {variant}", known[title],
                                                True, options)
    return ablations


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add_common_arguments(parser)
    add_data_argument(parser)
    parser.add_argument("--sets", help="names of sets, separated by commas; else all")
    parser.add_argument("--pairs", type=int, help="only the first pairs that are drawn of each set")
    parser.add_argument("--ablations", nargs="?", const=ABLATED_SETS, metavar="SETS",
                        help=f"measure variants too, on {ABLATED_SETS} or these sets")
    parser.add_argument("--jobs", type=int, default=1, help="matches at a time")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    known = data_sets.pairs_with_truth(arguments.data)
    across = data_sets.pairs_across_classes(arguments.data)
    wanted = arguments.sets.split(",") if arguments.sets else [*known, *across]
    for title in wanted:
        if title not in known and title not in across:
            raise SystemExit(f"there is no set {title}: {', '.join([*known, *across])}")
    all_results = {(title,): measure(arguments, title, known.get(title) or across[title],
                                     title in known)
                   for title in wanted}
    ablations = measure_ablations(arguments, known, all_results)
    text = page(arguments, all_results, ablations)
    print(text.split("\n## Pairs")[0])
    is_whole = not arguments.sets and arguments.pairs is None
    if arguments.out or is_whole:
        write_page(arguments.out or PAGE, text)


if __name__ == "__main__":
    main()
