#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""All methods under today's protocol, as docs/results/modern.md and .csv, and modern_SET.svg.

Usage: bench/tables/modern.py [--quick] [--out docs/results]
"""

import math

import comparison_sets
import plots
from common import mean, percentile, table_head, table_line, write_csv, write_page
from rivals import METHODS, STEP, Failure, behind, provenance, run_table, verdict

GROSS = 10  # Mean error, x100 over sqrt(area), above which a map is wrong as a whole.

HEADER = """# All methods, today's protocol

{provenance}

Errors are geodesic distances from the ground truth, x100 over sqrt(area) of the target, or of the whole
shape that a piece was cut from: the mean of each pair, then mean and median over pairs, of maps rounded
to vertices, where both the map and the truth have an answer. *IoU* is the area that both have over the
area that either has, where parts are missing. *Points* is the error of maps to points on triangles,
where a method makes such. *Flip allowed* counts, for each pair, the error against the truth or against its
left-right mirror image, whichever is less. *Flipped* maps are nearer to the mirror image; *wrong* ones are
not flipped and have an error above {gross}; *no flips* averages over the pairs that the method does not
flip. D_iso is over the largest geodesic distance. Seconds are
medians from meshes in memory to the map, geodesic graph included, on all cores; MiB the median peak
memory of the process, which holds one pair and one method.

Shapes of smal5k and partial_smal, which stand aligned, are turned at random first.

*paper-oriented* is the paper's method with `--orientation`. *spectral* (Jain and Zhang 2006), *gmds*
(Bronstein et al. 2006) and *zoomout* (Ren et al. 2018, Melzi et al. 2019) are our own
implementations. *gmds* maps 300 points and is measured on those; *spectral*
maps base vertices of level 4 and is extended to all vertices. The last column says what tracked is
ahead of each rival in, and where it is not.

"""

COLUMNS = ["method", "pairs", "mean error", "median", "points", "no flips", "flip allowed", "IoU",
           "flipped", "wrong", "failed", "D_iso", "seconds", "MiB", "tracked ahead"]


def decimal(value):
    return "–" if math.isnan(value) else f"{value:.2f}"


class Results:
    """What a method did on a set."""

    def __init__(self, method, maps):
        self.method = method
        self.failures = [m for m in maps if isinstance(m, Failure)]
        self.maps = [m for m in maps if not isinstance(m, Failure)]
        self.pairs = len(maps)
        self.errors = [m.error() for m in self.maps]
        self.error, self.median = mean(self.errors), percentile(self.errors, 0.5)
        self.flip_allowed = mean(m.flip_allowed() for m in self.maps)
        self.no_flips = mean(m.error() for m in self.maps if not m.flipped)
        self.seconds = percentile([m.seconds for m in self.maps], 0.5)
        self.mib = percentile([m.peak_mib for m in self.maps], 0.5)
        self.flipped = sum(m.flipped for m in self.maps)

    def points(self):
        values = [m.error("point_error") for m in self.maps
                  if "point_error_over_sqrt_area" in m.truth]
        return mean(values)

    def wrong(self):
        return sum(not m.flipped and m.error() > GROSS for m in self.maps)

    def iou(self):
        """NaN where nothing is missing."""
        lacking = any(m.truth["overlap"]["truly_matched_share"] < 1 for m in self.maps)
        return mean(m.overlap_iou for m in self.maps) if lacking else math.nan

    def cells(self):
        return [self.pairs, *map(decimal, (self.error, self.median, self.points(), self.no_flips,
                                            self.flip_allowed, self.iou())),
                self.flipped, self.wrong(), len(self.failures),
                f"{mean(m.d_iso for m in self.maps):.4f}", decimal(self.seconds),
                f"{self.mib:.0f}"]

    def knows_mirrored_truth(self):
        return any(m.symmetric is not m.truth for m in self.maps)

    def curve(self, flips_allowed):
        """Share of template points with an error up to each threshold, averaged over pairs."""
        return [mean(shares) for shares in zip(*(m.curve(flips_allowed) for m in self.maps))]


def ahead(method, results, tracked):
    """Whether tracked is ahead of a rival in mean and median error, and in time of today's rival."""
    if method == "tracked":
        return ""
    if not results.maps or not tracked.maps:
        return "–"
    figures = {"mean": "error", "median": "median", "flip allowed": "flip_allowed"}
    if method == "zoomout":  # Of the others, some make maps that are no rivals to its own.
        figures["seconds"] = "seconds"
    return verdict([remark for name, attribute in figures.items()
                    for remark in behind(name, round(getattr(tracked, attribute), 2),
                                         {method: round(getattr(results, attribute), 2)})])


def section(title, all_results):
    lines = [f"## {title}", "", f"![cumulative error](modern_{title}.svg)", "",
             *table_head(COLUMNS)]
    lines += [table_line([method, *results.cells(), ahead(method, results, all_results["tracked"])])
              for method, results in all_results.items()]
    lines += [f"\n{failure.pair.name}: {failure.method} failed, {failure.reason}"
              for results in all_results.values() for failure in results.failures]
    return "\n".join(lines)


def plot(path, title, all_results):
    lines = {}
    for method, results in all_results.items():
        for flips_allowed, dash, note in ((False, "-", ""), (True, ":", " (flip allowed)")):
            if flips_allowed and not results.knows_mirrored_truth():
                continue
            curve = results.curve(flips_allowed)
            lines[method + note] = ([STEP * i for i in range(len(curve))], curve, dash)
    plots.line_plot(path, lines, "geodesic error over sqrt(area)", "share of points",
                    f"{title}: error of the map", {"xlim": (0, 0.25), "ylim": (0, 1)})


def csv_rows(sets):
    for title, all_results in sets.items():
        for results in all_results.values():
            for m in results.maps:
                points = m.error("point_error") if "point_error_over_sqrt_area" in m.truth else ""
                yield (title, m.pair.name, m.method, m.error(), points, m.flip_allowed(),
                       int(m.flipped), m.d_iso, m.d_iso_max, round(m.seconds, 3),
                       round(m.peak_mib, 1))


def curve_rows(sets):
    for title, all_results in sets.items():
        for method, results in all_results.items():
            for i, shares in enumerate(zip(results.curve(False), results.curve(True))):
                yield title, method, round(STEP * i, 3), *shares


def measured_sets(bench, data, quick):
    """Results by set and method."""
    sets = {}
    for title, pairs in comparison_sets.all_sets(data, quick, bench.folder.parent).items():
        for pair in pairs:
            bench.measure(pair, METHODS)
        sets[title] = {method: Results(method, [bench.map(pair, method) for pair in pairs])
                       for method in METHODS}
    return sets


def make(bench, data, folder, quick, command):
    sets = measured_sets(bench, data, quick)
    for title in sets:
        plot(folder / f"modern_{title}.svg", title, sets[title])
    text = HEADER.format(provenance=provenance(command), gross=GROSS)
    write_page(folder / "modern.md", text + "\n\n".join(section(*item) for item in sets.items()) + "\n")
    write_csv(folder / "modern.csv", ["data", "pair", "method", "error", "point_error",
                                      "flip_allowed_error", "flipped", "d_iso", "d_iso_max",
                                      "seconds", "peak_mib"], csv_rows(sets))
    write_csv(folder / "modern_curves.csv", ["data", "method", "error_over_sqrt_area", "share",
                                             "share_flip_allowed"], curve_rows(sets))


if __name__ == "__main__":
    run_table(__doc__, make)
