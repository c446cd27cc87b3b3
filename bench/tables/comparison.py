# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Tables 1 and 2 of the paper: distortion of several maps, a line for each data set."""

import dataclasses

from common import table_head, table_line
from rivals import Failure, behind, figure, verdict


@dataclasses.dataclass
class Row:
    title: str
    pairs: list
    # What the paper reports for each column: D_iso and d_iso†, D_grd and d_grd†.
    d_iso: dict
    d_grd: dict = dataclasses.field(default_factory=dict)


# Names of two figures, and the attributes of a map and of a row that hold them.
D_ISO = (("D_iso", "d_iso"), ("d_iso†", "d_iso_max")), "d_iso"
D_GRD = (("D_grd", "d_grd"), ("d_grd†", "d_grd_max")), "d_grd"

CSV_COLUMNS = ["data", "pair", "map", "matches", "d_iso", "d_iso_max", "d_grd", "d_grd_max",
               "flipped", "seconds"]


class Results:
    """The maps of a row's pairs: for each pair a dictionary by column, which has method and map."""

    def __init__(self, bench, row, columns, count=None):
        self.row, self.columns = row, columns
        self.pairs, self.failures = [], []
        for pair in row.pairs[:count]:
            bench.measure(pair, list(dict.fromkeys(method for method, _ in columns.values())))
            maps = {title: bench.map(pair, *column) for title, column in columns.items()}
            failed = [m for m in maps.values() if isinstance(m, Failure)]
            self.failures += failed
            if not failed:
                self.pairs.append(maps)

    def without_flips(self):
        return [maps for maps in self.pairs if not any(m.flipped for m in maps.values())]

    def means(self, pairs, title, figures):
        return [figure(getattr(maps[title], attribute) for maps in pairs)
                for _, attribute in figures]

    def cell(self, pairs, title, figures, published):
        text = ", ".join(self.means(pairs, title, figures))
        if title in published:
            text += " [" + ", ".join(f"{value:.3f}".lstrip("0") for value in published[title]) + "]"
        return text

    def ahead(self, pairs, figures):
        """Whether tracked is best, and who is better if not."""
        means = {title: self.means(pairs, title, figures) for title in self.columns}
        own = means.pop("tracked")
        return verdict([remark for k, (name, _) in enumerate(figures)
                        for remark in behind(name, own[k], {t: m[k] for t, m in means.items()})])

    def lines(self, kind):
        figures, published = kind
        for which, pairs in (("all", self.pairs), ("no flips", self.without_flips())):
            cells = [self.cell(pairs, title, figures, getattr(self.row, published))
                     for title in self.columns]
            ahead = self.ahead(pairs, figures) if pairs else "–"
            yield table_line([self.row.title, f"{which}: {len(pairs)}", *cells, ahead])

    def outcome_lines(self):
        flips = ", ".join(f"{title} {sum(maps[title].flipped for maps in self.pairs)}"
                          for title in self.columns)
        yield f"- {self.row.title}, {len(self.pairs)} pairs: {flips}"
        for failure in self.failures:
            yield f"- {failure.pair.name}: {failure.method} failed, {failure.reason}"

    def csv_rows(self):
        for maps in self.pairs:
            for title, m in maps.items():
                truth = (m.d_grd, m.d_grd_max) if m.truth else ("", "")
                yield (self.row.title, m.pair.name, title, m.matches, m.d_iso, m.d_iso_max, *truth,
                       int(m.flipped), round(m.seconds, 3))


def table(all_results, kind):
    head = table_head(["data", "pairs", *all_results[0].columns, "tracked ahead"])
    return "\n".join(head + [line for results in all_results for line in results.lines(kind)])


def outcomes(all_results):
    return "\n".join(line for results in all_results for line in results.outcome_lines())


def csv_rows(all_results):
    return (row for results in all_results for row in results.csv_rows())
