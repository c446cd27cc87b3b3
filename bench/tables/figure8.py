#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""The paper's Figure 8: D_iso at each level, as docs/results/figure8.md, .csv and .svg.

Usage: bench/tables/figure8.py [--quick] [--out docs/results]
"""

import data_sets
import plots
from common import mean, table_head, table_line, write_csv, write_page
from rivals import Failure, figure, provenance, run_table

PAIRS = 6

TEXT = """# Figure 8: distortion at each level

{provenance}

D_iso of the many-to-many correspondence ξ(k) of the paper's method at level k, over the largest
geodesic distance and against the E = 100 matches in use at the level, averaged over the pairs that
have such a level, {pairs} of each data set (with fewer at the last levels). The paper plots the same,
without figures, for six pairs: distortion falls with the level, but for a small rise from level 0 to
level 1.

![D_iso per level](figure8.svg)

"""


def pair_sets(data, quick):
    modern = data_sets.modern_pairs(data, quick)
    return {"Horse Gallop": data_sets.gallop_pairs(data),
            "Jumping Man": data_sets.jumping_pairs(data),
            "Dog-Wolf": data_sets.dog_wolf_pairs(data),
            "Wolf-Horse Gallop": data_sets.wolf_gallop_pairs(data),
            "TOSCA": modern["tosca5k"],
            "FAUST": modern["faust5k"]}


def levels_of(bench, pairs):
    """For each pair D_iso of its levels."""
    maps = [bench.map(pair, "paper") for pair in pairs]
    return [[level["d_iso"] for level in m.levels] for m in maps if not isinstance(m, Failure)]


def means_by_level(levels):
    count = max(map(len, levels), default=0)
    return [mean(pair[k] for pair in levels if k < len(pair)) for k in range(count)]


def summary(means):
    """What the paper says of its figure, of ours."""
    rise = "rises" if len(means) > 1 and means[1] > means[0] else "falls"
    least = means.index(min(means))
    return [figure([means[0]]), rise, figure([means[least]]), least, figure([means[-1]])]


def make(bench, data, folder, quick, command):
    count = 1 if quick else PAIRS
    levels = {title: levels_of(bench, pairs[:count])
              for title, pairs in pair_sets(data, quick).items()}
    means = {title: means_by_level(pairs) for title, pairs in levels.items() if pairs}
    lines = table_head(["data", "pairs", "k = 0", "to k = 1 it", "least", "at k", "last"])
    lines += [table_line([title, len(levels[title]), *summary(m)]) for title, m in means.items()]
    write_page(folder / "figure8.md",
               TEXT.format(provenance=provenance(command), pairs=count) + "\n".join(lines) + "\n")
    write_csv(folder / "figure8.csv", ["data", "level", "pairs", "d_iso"],
              [(title, k, sum(k < len(pair) for pair in levels[title]), value)
               for title, m in means.items() for k, value in enumerate(m)])
    plots.line_plot(folder / "figure8.svg",
                    {title: (range(len(m)), m, "-") for title, m in means.items()},
                    "level k", "D_iso over the largest geodesic", "Isometric distortion per level",
                    {"ylim": (0, None)}, markers=20)


if __name__ == "__main__":
    run_table(__doc__, make)
