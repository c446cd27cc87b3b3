#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Label transfer measured: labels are geodesic Voronoi regions (along edges) of template points,
drawn farthest point first on one person; the ground truth says which label is right on the other.
Writes docs/results/transfer.md."""

import argparse
import heapq
import math
import pathlib
import tempfile

import common
from data_sets import Pair
from meshes import read_shape

PAIRS = (("tr_reg_000", "tr_reg_013", "two people"), ("tr_reg_000", "tr_reg_004", "one person"),
         ("tr_reg_015", "tr_reg_021", "two people"), ("tr_reg_002", "tr_reg_009", "one person"))
REGIONS = (8, 16, 32)
WAYS = ("given", "inverted")


def neighbours(shape):
    lists = [{} for _ in shape.vertices]
    for face in shape.faces:
        for k in range(3):
            a, b = face[k], face[k - 1]
            lists[a][b] = lists[b][a] = math.dist(shape.vertices[a], shape.vertices[b])
    return lists


def nearest_seed(lists, seeds):
    """For each vertex the index of the nearest of `seeds` along edges, and how far it is."""
    distance, label = [math.inf] * len(lists), [-1] * len(lists)
    queue = []
    for index, seed in enumerate(seeds):
        distance[seed], label[seed] = 0.0, index
        queue.append((0.0, index, seed))
    heapq.heapify(queue)
    while queue:
        d, index, v = heapq.heappop(queue)
        if d > distance[v]:
            continue
        for w, length in lists[v].items():
            if d + length < distance[w]:
                distance[w], label[w] = d + length, index
                heapq.heappush(queue, (d + length, index, w))
    return label, distance


def regions(shape, count):
    """Labels of all vertices, by `count` template points as far as possible from each other."""
    lists = neighbours(shape)
    candidates = sorted(set(shape.truth))
    seeds = [shape.truth[0]]
    distance = nearest_seed(lists, seeds)[1]
    while len(seeds) < count:
        seeds.append(max(candidates, key=lambda v: distance[v]))
        distance = [min(both) for both in zip(distance, nearest_seed(lists, seeds[-1:])[1])]
    return nearest_seed(lists, seeds)[0]


def is_border(shape, labels):
    """For each vertex whether an edge leads to another label."""
    border = [False] * len(labels)
    for face in shape.faces:
        if len({labels[v] for v in face}) > 1:
            for v in face:
                border[v] = True
    return border


def accuracy(source, target, labels, carried):
    """Shares of template points with the right label: of all, and of those whose source vertex is
    not at a border, where the rounding of the truth to vertices decides."""
    border = is_border(source, labels)
    right = [labels[s] == carried[t] for s, t in zip(source.truth, target.truth)]
    inside = [is_right for is_right, s in zip(right, source.truth) if not border[s]]
    return common.mean(right), common.mean(inside)


def measure(arguments, source_name, target_name, folder):
    """For each number of regions the accuracies by both maps."""
    pair = Pair(arguments.data / "faust5k", ".off", source_name, target_name)
    source, target = (read_shape(pair.folder, name) for name in (source_name, target_name))
    result = folder / f"{source_name}-{target_name}"
    common.run([arguments.program, "match", *pair.meshes, "-o", result, "--quiet",
                "--target-to-source"])
    results = {}
    all_labels = {count: regions(source, count) for count in REGIONS}
    for ways in WAYS:
        if ways == "inverted":
            (result / "target_to_source.bary.txt").unlink()
        for count, labels in all_labels.items():
            given, carried = folder / "labels.txt", folder / "carried.txt"
            given.write_text("".join(f"{label}\n" for label in labels))
            common.run([arguments.program, "transfer", result, "--labels", given, "-o", carried])
            results[ways, count] = accuracy(source, target, labels,
                                            [int(word) for word in carried.read_text().split()])
    return results


def page(rows):
    lines = ["# Labels carried over between people", "",
             f"Made by `bench/tables/transfer.py`, {common.machine()}, {common.commit()}.",
             "", "Regions of one person, each the vertices nearest to one of 8, 16 or 32 template "
             "points, are carried over by `isomatch transfer --labels` to another. Per cent of all "
             "template points that get the right label; in brackets, of those whose source vertex "
             "has no neighbour of another label: at a border the rounding of the ground truth to "
             "vertices decides. *Given* uses the map from target to source that `match "
             "--target-to-source` writes, *inverted* what `transfer` makes of the map from source "
             "to target.", ""]
    columns = ["pair", "", *[f"{count}, {ways}" for count in REGIONS for ways in WAYS]]
    lines += common.table_head(columns)
    for source, target, kind, results in rows:
        cells = ["{:.1f} ({:.1f})".format(*(100 * share for share in results[ways, count]))
                 for count in REGIONS for ways in WAYS]
        lines.append(common.table_line([f"{source} to {target}", kind, *cells]))
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    common.add_common_arguments(parser, "transfer.md")
    common.add_data_argument(parser)
    parser.add_argument("--pairs", type=int, default=len(PAIRS), help="how many of the pairs")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = [(source, target, kind,
                 measure(arguments, source, target, pathlib.Path(folder)))
                for source, target, kind in PAIRS[:arguments.pairs]]
    common.write_page(arguments.out, page(rows))


if __name__ == "__main__":
    main()
