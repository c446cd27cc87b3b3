# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""How well a map between two surfaces agrees with the truth where only parts correspond."""

import dataclasses
import json

import numpy as np

SAMPLES = 400  # Points at which errors are measured.
MIRRORED_SAMPLES = 100  # Of these, points at which they are compared with the mirrored truth.
CLOSE = .05  # Error over sqrt(area) up to which a vertex counts as right.
TENTHS = 10  # Classes of confidence.


@dataclasses.dataclass
class Map:
    """The target face of each source vertex, -1 for none, and the weights of its corners."""
    faces: np.ndarray
    weights: np.ndarray
    confidence: np.ndarray = None

    @property
    def matched(self):
        return self.faces >= 0


def map_of_vertices(images, target):
    """The map to vertices of the target, -1 for none, as points on triangles."""
    corner_of = np.full(len(target.vertices) + 1, -1)
    corner_of[target.faces.ravel()] = np.arange(target.faces.size)
    corner = corner_of[images]
    weights = np.zeros((len(images), 3))
    weights[np.arange(len(images)), corner % 3] = corner >= 0
    return Map(np.where(corner < 0, -1, corner // 3), weights)


def read_map(folder, target):
    points = folder / "source_to_target.bary.txt"
    if points.exists():
        lines = np.loadtxt(points, ndmin=2)
        result = Map(lines[:, 0].astype(int), lines[:, 1:])
    else:
        result = map_of_vertices(np.loadtxt(folder / "source_to_target.txt", int), target)
    confidence = folder / "source_confidence.txt"
    if confidence.exists():
        result.confidence = np.loadtxt(confidence, ndmin=1)
    return result


def true_map(truth, source, target):
    """The truth as a map, of which the first of several images of a vertex is taken."""
    images = np.full(len(source.vertices), -1)
    order = slice(None, None, -1)
    images[truth.source[order]] = truth.target[order]
    return map_of_vertices(images, target)


def evenly(places, count):
    """At most `count` of these."""
    if len(places) <= count:
        return places
    return places[np.linspace(0, len(places) - 1, count).astype(int)]


def share(part, whole):
    """None where it would be 0 / 0."""
    return float(part / whole) if whole > 0 else None


def overlap_scores(truth, matched, source):
    """Points weigh alike, vertices as much as the area around them."""
    weights = source.vertex_areas if truth.every_vertex else np.ones(len(truth.source))
    said, true = matched[truth.source], truth.target >= 0

    def total(chosen):
        return weights[chosen].sum()

    return {"iou": share(total(said & true), total(said | true)),
            "precision": share(total(~said & ~true), total(~said)),
            "recall": share(total(~said & ~true), total(~true)),
            "overlap": share(total(true), weights.sum()),
            "unmatched": float(1 - matched.mean())}


def errors(distances, found, points, vertices):
    """Distances of the images of source points from vertices of the target."""
    return distances.between(vertices, found.faces[points], found.weights[points])


def is_flipped(truth, found, distances, samples, true_errors):
    """Nearer to the mirrored truth; None if it is not known."""
    if truth.symmetric is None:
        return None
    known = np.flatnonzero(truth.symmetric[samples] >= 0)
    few = evenly(known, MIRRORED_SAMPLES)
    if len(few) == 0:
        return None
    mirrored = errors(distances, found, truth.source[samples[few]],
                      truth.symmetric[samples[few]])
    return bool(mirrored.mean() < true_errors[few].mean())


def calibration(truth, found, samples, right):
    """In each tenth of confidence, the share of the points matched by the map, and of those that
    are right; where nothing is true, no match is."""
    if found.confidence is None:
        return None
    matched = found.matched[truth.source]
    known = (matched & (truth.target >= 0)).sum()
    nowhere = np.flatnonzero(matched & (truth.target < 0))
    points = truth.source[np.concatenate([samples, nowhere])]
    weights = np.concatenate([np.full(len(samples), known / max(1, len(samples))),
                              np.ones(len(nowhere))]) / max(1, matched.sum())
    tenth = np.clip((TENTHS * found.confidence[points]).astype(int), 0, TENTHS - 1)
    right = np.concatenate([right, np.zeros(len(nowhere), bool)])
    return [[float(weights[tenth == k].sum()), float(weights[(tenth == k) & right].sum())]
            for k in range(TENTHS)]


def scores(truth, found, source, target, area, distances):
    """All figures of a map but those of landmarks; errors x100 over sqrt(area)."""
    both = np.flatnonzero((truth.target >= 0) & found.matched[truth.source])
    samples = evenly(both, SAMPLES)
    found_errors = errors(distances, found, truth.source[samples], truth.target[samples])
    result = overlap_scores(truth, found.matched, source)
    result["error"] = None
    if len(samples):
        result["error"] = float(100 * found_errors.mean() / np.sqrt(area))
        result["median_error"] = float(100 * np.median(found_errors) / np.sqrt(area))
    result["flipped"] = is_flipped(truth, found, distances, samples, found_errors)
    result["calibration"] = calibration(truth, found, samples,
                                        found_errors <= CLOSE * np.sqrt(area))
    return result


def landmark_scores(truth, found, target, distances):
    """Straight distances in the units of the file, and x100 over sqrt(area)."""
    known = found.matched[truth.source]
    chosen = truth.source[known]
    points = distances.points(found.faces[chosen], found.weights[chosen])
    lengths = np.linalg.norm(points - target.vertices[truth.target[known]], axis=1)
    length = float(lengths.mean()) if len(lengths) else None
    return {"landmarks": len(lengths), "length": length,
            "error": length and 100 * length / float(np.sqrt(target.area)),
            "unmatched": float(1 - found.matched.mean())}


def read_report(folder):
    """Grade, reasons and whether the map reverses orientation, None if that cannot be told."""
    fit = json.loads((folder / "report.json").read_text()).get("fit", {})
    reversed_share = fit.get("reversed")
    return {"grade": fit.get("grade", ""), "reasons": fit.get("reasons", []),
            "reverses": None if reversed_share is None else reversed_share > .5}
