# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""The tables of `partial.py`."""

from common import commit, machine, mean, percentile, table_head, table_line
from partial_scores import CLOSE, SAMPLES, TENTHS

GROSS = 10  # Mean error, x100 over sqrt(area), above which a map is wrong as a whole.


def figure(value, form=".2f"):
    return "" if value is None or value != value else format(value, form)


def is_flipped(row):
    """By the mirrored truth; where there is none, by the orientation of the map."""
    return bool(row.get("reverses") if row.get("flipped") is None else row["flipped"])


def is_wrong(row):
    return not is_flipped(row) and (row["error"] is None or row["error"] > GROSS)


def line(row):
    """A pair in a line of text."""
    if "failure" in row:
        return f"{row['name']}  {row['failure']}"
    parts = [row["name"], f"error {figure(row['error'])}"]
    if row.get("length"):
        parts.append(f"{row['length']:.2f} mm at {row['landmarks']} landmarks")
    for key in ("iou", "precision", "recall"):
        if row.get(key) is not None:
            parts.append(f"{key} {row[key]:.2f}")
    parts += [f"unmatched {row['unmatched']:.2f}", f"{row['seconds']:.1f} s", row.get("grade", "")]
    if "rigid" in row:
        parts.append(f"rigid {figure(row['rigid']['length'])} mm")
    return "  ".join([*parts, *(["flipped"] if is_flipped(row) else [])])


def of(rows, key):
    return [row[key] for row in rows if row.get(key) is not None]


COLUMNS = ["pairs", "error", "median", "worst pair", "IoU", "precision", "recall", "unmatched",
           f"above {GROSS}", "flipped", "failed", "good, doubtful, poor", "seconds"]


def cells(all_rows):
    rows = [row for row in all_rows if "failure" not in row]
    errors = of(rows, "error")
    worst = max((row for row in rows if row["error"] is not None), key=lambda row: row["error"],
                default=None)
    grades = of(rows, "grade")
    return [len(all_rows), figure(mean(errors)), figure(percentile(errors, .5)),
            f"{worst['name']}: {worst['error']:.2f}" if worst else "",
            *(figure(mean(of(rows, key))) for key in ("iou", "precision", "recall", "unmatched")),
            sum(map(is_wrong, rows)), sum(map(is_flipped, rows)), len(all_rows) - len(rows),
            ", ".join(str(grades.count(grade)) for grade in ("good", "doubtful", "poor")),
            figure(percentile(of(rows, "seconds"), .5), ".1f")]


def larger_overlaps(rows):
    """The half of the pairs of which more is common to both."""
    known = sorted((row for row in rows if row.get("overlap")), key=lambda row: row["overlap"])
    return known[len(known) // 2:]


def groups(rows):
    """Rows of each set, and of what is reported on its own within it."""
    result = {}
    for title in dict.fromkeys(row["set"] for row in rows):
        own = [row for row in rows if row["set"] == title]
        result[title, ""] = own
        for group in dict.fromkeys(row["group"] for row in own if row["group"]):
            result[title, group] = [row for row in own if row["group"] == group]
        if title == "partial_smal" and len(own) > 1:
            result[title, "larger overlaps"] = larger_overlaps(own)
    return result


def summary(rows):
    lines = [table_line([*key, *cells(own)]) for key, own in groups(rows).items()]
    return "\n".join(table_head(["data", "", *COLUMNS]) + lines)


def landmark_cells(title, rows):
    lengths = of(rows, "length")
    worst = max(rows, key=lambda row: row["length"] or 0, default=None)
    return [title, len(rows), *(figure(value(lengths)) for value in (
        mean, lambda values: percentile(values, .5))),
            f"{worst['name']}: {figure(worst['length'])}" if worst else "",
            figure(mean(of(rows, "error"))), figure(mean(of(rows, "landmarks")), ".1f"),
            figure(percentile(of(rows, "seconds"), .5), ".1f")]


def landmark_table(rows):
    skulls = [row for row in rows if "length" in row]
    rigid = [{"name": row["name"], **row["rigid"]} for row in rows if "rigid" in row]
    if not skulls and not rigid:
        return ""
    columns = ["method", "pairs", "mean mm", "median", "worst pair", "error", "landmarks matched",
               "seconds"]
    lines = [table_line(landmark_cells("tracked", skulls))]
    if rigid:
        lines.append(table_line(landmark_cells("rigid alignment with nearest vertices", rigid)))
    return "\n".join(["", "", "## Landmarks of skulls", "", *table_head(columns), *lines])


def calibration(rows):
    """In each tenth of confidence the share of matches in it, and of these the share that is right,
    None if there are none; every pair weighs alike."""
    known = of(rows, "calibration")
    totals = [[sum(pair[k][i] for pair in known) for i in (0, 1)] for k in range(TENTHS)]
    return [(matched / max(1, len(known)), right / matched if matched > 0 else None)
            for matched, right in totals] if known else []


def calibration_table(rows, picture):
    tenths = calibration(rows)
    if not tenths:
        return ""
    lines = [table_line([f"{k / TENTHS:.1f} to {(k + 1) / TENTHS:.1f}", figure(matched, ".3f"),
                         figure(right, ".3f")]) for k, (matched, right) in enumerate(tenths)]
    head = table_head(["confidence", "share of matches", "of these right"])
    return "\n".join(["", "", "## Confidence", "", "A match is right if its error is at most "
                      f"{CLOSE} sqrt(area); where there is no counterpart, none is.", "", *head,
                      *lines, "", *([f"![Confidence]({picture})"] if picture else [])])


def plot_calibration(rows, path):
    """Needs matplotlib, unlike all else here."""
    from plots import line_plot
    known = [((k + .5) / TENTHS, right) for k, (_, right) in enumerate(calibration(rows))
             if right is not None]
    lines = {"found": (*zip(*known), "-"), "perfect": ((0, 1), (0, 1), "--")}
    line_plot(path, lines, "confidence", "share of matches that are right", "Confidence",
              {"xlim": (0, 1), "ylim": (0, 1)})


def comparison(rows, earlier_rows):
    """The means of each group in an earlier run and in this one, over the pairs that are in both,
    and the pairs that became better or worse most."""
    earlier = {(row["set"], row["name"]): row for row in earlier_rows if row.get("error")}
    both = [(earlier[row["set"], row["name"]], row) for row in rows
            if row.get("error") and (row["set"], row["name"]) in earlier]
    columns = ["error", "iou", "precision", "recall", "unmatched", "seconds"]
    lines = table_head(["data", "", "pairs", *columns])
    for key, own in groups([row for _, row in both]).items():
        pairs = [(old, row) for old, row in both if any(row is chosen for chosen in own)]
        means = [[figure(mean(of(side, column))) for side in zip(*pairs)] for column in columns]
        changes = [" to ".join(two) if any(two) else "" for two in means]
        lines.append(table_line([*key, len(pairs), *changes]))
    both.sort(key=lambda pair: pair[1]["error"] - pair[0]["error"])
    lines += ["", "Changed most:"]
    lines += [f"  {row['set']} {row['name']}: {old['error']:.2f} to {row['error']:.2f}"
              for old, row in (both if len(both) <= 10 else both[:5] + both[-5:])]
    return "\n".join(lines)


HEADER = """# Pieces, fused parts and rigid shapes

Made by `bench/tables/partial.py` at commit {commit} on {machine}; {jobs} at a time, of {threads}
threads{options}. Every shape was turned and shifted by itself.{share}

"""

TEXT = """Errors are geodesic distances of a pair's map to points on triangles from the truth,
x100 over sqrt(area), averaged over what has an answer in both, at {samples} places of a pair or
less; of skulls straight distances of landmarks. The area is the target's; for partial_cuts that
of the larger uncut shape, for partial_smal 1, the area of the whole animals. *IoU* is that of the
matched and the truly common part of the source, *precision* and *recall* those of what was said
to have no counterpart, *unmatched* the share of vertices of which that was said. Maps *above
{gross}* are not flipped. *Flipped* ones are nearer to the left-right symmetric truth than to the
true one; where none is known, they reverse orientation. The *larger overlaps* are the half of the
pairs with more in common. Seconds are the median wall time of the whole program. The truth of
remeshed shapes (faust5k, tosca5k, smal5k and pieces of the first two) is a nearest vertex: it
differs from itself by .2 to .6, where several points share a vertex.

"""


def pairs_section(rows):
    lines = ["", "", "## Pairs", ""]
    columns = ["error", "iou", "precision", "recall", "overlap", "unmatched"]
    lines += table_head(["data", "pair", *columns, "flipped", "fit", "seconds"])
    for row in rows:
        if "failure" in row:
            lines.append(table_line([row["set"], row["name"], row["failure"]]))
            continue
        lines.append(table_line([row["set"], row["name"], *(figure(row.get(k)) for k in columns),
                                 "yes" if is_flipped(row) else "", row.get("grade", ""),
                                 figure(row["seconds"], ".1f")]))
    return "\n".join(lines)


def share_of_pairs(arguments):
    if arguments.every == 1:
        return ""
    return f" Of each set one pair in {arguments.every} was matched."


def page(arguments, rows, picture):
    """`picture`: the file of the plot of confidence, beside the page, or None."""
    options = "".join(f" {word}" for word in arguments.options)
    text = HEADER.format(commit=commit(), machine=machine(), jobs=arguments.jobs,
                         threads=arguments.threads, options=options and f", with{options}",
                         share=share_of_pairs(arguments))
    text += TEXT.format(gross=GROSS, samples=SAMPLES) + summary(rows) + landmark_table(rows)
    return text + calibration_table(rows, picture) + pairs_section(rows) + "\n"


def without_pairs(text):
    return text[:text.index("\n## Pairs")]
