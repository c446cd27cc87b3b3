#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""All sets down, all methods across, as docs/results/index.md, and the figures of README and docs.

Usage: bench/tables/index.py [--quick] [--out docs/results]
"""

import json
import math

import blocks
import data_sets
import modern
import table1
from common import ROOT, evaluate, mean, table_head, table_line, write_page
from comparison import D_GRD, D_ISO, Results
from rivals import METHODS, provenance, run_table

TITLES = {"faust5k": "FAUST, three people in ten poses", "tosca5k": "TOSCA, within classes",
          "horse_gallop": "Horse Gallop", "jumping_man": "Jumping Man",
          "smal5k": "SMAL, across species", "partial_cuts": "pieces, cut or with holes",
          "partial_smal": "parts of animals, across species",
          "topo_kids": "KIDS with fused contacts"}

TEXT = """# Results

{provenance}
It makes all pages of this folder that compare methods; what is behind the figures here, pair by pair, is in
`modern.csv`.

Errors are geodesic distances x100 over sqrt(area), of maps rounded to vertices; what is measured, and
each method, is described in [modern.md](modern.md). *Perfect* is what the exact truth itself scores by
the truth that is used, which of remeshed shapes is a nearest vertex; 0 where shapes share their vertices.

## Errors

Mean over the pairs, and the median pair in brackets.

{errors}

## Flipped, wrong, failed

Of the pairs: maps that are nearer to the mirror image or turn the surface over, maps that are not but
have an error above {gross}, and pairs without a map.

{outcomes}

## What is missing

Intersection over union of what a method matches and what has a counterpart. Rivals match all vertices;
gmds has only its 300 points, of which this cannot be said.

{overlap}

## Time and memory

Median seconds of a pair, from meshes in memory to the map, and MiB of the process.

{times}

## Where tracked is not ahead

In mean or median error, and in seconds against zoomout, today's rival:

{behind}

## The paper's figures

Horse Gallop, ten pairs; all of them are in [Table 1](table1.md), [Table 2](table2.md) and
[Figure 8](figure8.md).

{paper}

## What others published

Of other authors, not measured again; x100 over sqrt(area), means of the remeshed sets, of which those
here are parts or, of KIDS, the like. Methods of the first column were trained on shapes of the same kind;
those of the second see shapes that stand aligned.

{published}

Trained: Cao, Roetzer and Bernard, Unsupervised learning of robust spectral shape matching, 2023; Bastian,
Xie, Navab and Lähner, Hybrid functional maps, 2024; parts: Ehm et al., Partial-to-partial shape matching
with geometric consistency, 2024. Aligned: Eisenberger, Lähner and Cremers, Smooth shells, 2020. Neither:
what the same publications compare themselves with.

Smooth shells, the strongest without training, are not among the rivals that are measured here: with the
authors' code a pair takes 145 s, so that the pairs of this page would take four hours instead of
minutes, and a quicker one of our own would be another method. By that code the median pair of
FAUST has 1.24, with one in ten flipped, and TOSCA 2.16, on poses that it sees aligned.
"""

PUBLISHED = [("FAUST", "1.4 to 1.6", "2.5, 1.8", "2.5 and more"),
             ("SMAL, across species", "2.6 to 3.5", "–", "9.1"),
             ("parts of animals, across species", "4.3 to 5.6, IoU .83 to .85", "–", "–"),
             ("KIDS with fused contacts", "3.3 to 5", "–", "10.8")]


def perfect(bench, pair):
    """What the exact truth scores; None if there is none."""
    file = bench.folder.parent / "perfect" / f"{pair.name.replace(' ', '__')}.json"
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        truth = file.with_suffix(".bary.txt")
        if not pair.write_exact_map(truth):
            return None
        program = bench.program.parent.parent / "tools/isomatch"
        found = evaluate(program, *pair.meshes, truth, pair.truth)["ground_truth"]
        file.write_text(json.dumps(100 * found["error_over_sqrt_area"]["mean"]))
        truth.unlink()
    return json.loads(file.read_text())


def perfect_cell(bench, title, results):
    if title in ("horse_gallop", "jumping_man"):
        return "0"
    pairs = [m.pair for m in results.maps if isinstance(m.pair, data_sets.Pair)]
    scores = [score for score in (perfect(bench, pair) for pair in pairs) if score is not None]
    return modern.decimal(mean(scores)) if scores else "–"


def across(sets, cell, last=()):
    """A line for each set, a column for each method, and maybe a last one by set."""
    head = ["data", "pairs", *METHODS, *(["perfect"] if last else [])]
    lines = [table_line([TITLES[title], results["tracked"].pairs, *(cell(r) for r in results.values()),
                         *([last[title]] if last else [])])
             for title, results in sets.items()]
    return "\n".join(table_head(head) + lines)


def error_cell(results):
    return f"{modern.decimal(results.error)} ({modern.decimal(results.median)})"


def outcome_cell(results):
    return f"{results.flipped}, {results.wrong()}, {len(results.failures)}"


def iou_cell(results):
    return "–" if results.method == "gmds" else modern.decimal(results.iou())


def behind_lines(sets):
    lines = [f"- {TITLES[title]}, {method}: {remark.removeprefix('**no**: ')}"
             for title, all_results in sets.items() for method, results in all_results.items()
             for remark in [modern.ahead(method, results, all_results["tracked"])]
             if remark.startswith("**no**")]
    return "\n".join(lines) or "Nowhere."


def paper_block(bench, data, quick):
    """The paper's figures of its own data beside ours."""
    gallop = Results(bench, table1.rows(data)[0], table1.COLUMNS, 1 if quick else None)

    def ours(pairs, title, kind):
        return gallop.means(pairs, title, kind[0])[0]

    lines = [["D_iso of the dense many-to-many map", ".008", ours(gallop.pairs, "ξ(K)", D_ISO)],
             ["D_grd of ξ(4,1), pairs that no method flips", ".039",
              ours(gallop.without_flips(), "ξ(4,1)", D_GRD)]]
    return "\n".join(table_head(["Horse Gallop", "the paper", "isomatch"]) +
                     [table_line(line) for line in lines])


def best_rival(results):
    rivals = {method: r for method, r in results.items()
              if method not in ("tracked", "paper-oriented") and not math.isnan(r.error)}
    method = min(rivals, key=lambda name: rivals[name].error)
    return f"{rivals[method].error:.2f} ({method})"


def short_block(sets):
    """What the README shows."""
    lines = [table_line([TITLES[title], results["tracked"].pairs,
                         f"{results['tracked'].error:.2f}", f"{results['tracked'].median:.2f}",
                         results["tracked"].flipped, best_rival(results)])
             for title, results in sets.items()]
    return "\n".join(table_head(["", "pairs", "mean", "median pair", "flipped",
                                 "mean of the best rival"]) + lines)


def make(bench, data, folder, quick, command):
    sets = modern.measured_sets(bench, data, quick)
    last = {title: perfect_cell(bench, title, results["tracked"]) for title, results in sets.items()}
    partial = {title: results for title, results in sets.items()
               if not math.isnan(results["tracked"].iou())}
    own = {"results": short_block(sets), "paper": paper_block(bench, data, quick)}
    text = TEXT.format(
        provenance=provenance(command), gross=modern.GROSS, errors=across(sets, error_cell, last),
        outcomes=across(sets, outcome_cell),
        overlap=across(partial, iou_cell),
        times=across(sets, lambda r: f"{modern.decimal(r.seconds)}, {r.mib:.0f}"),
        behind=behind_lines(sets), paper=blocks.block("paper", own["paper"]),
        published="\n".join(table_head(["", "trained", "aligned", "neither"]) +
                            [table_line(line) for line in PUBLISHED]))
    text += "\n## In short\n\n" + blocks.block("results", own["results"]) + "\n"
    write_page(folder / "index.md", text)
    if folder.resolve() == (ROOT / "docs/results").resolve() and not quick:
        blocks.copy_to_documents(own)


if __name__ == "__main__":
    run_table(__doc__, make)
