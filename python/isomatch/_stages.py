# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""The stages of matching, each by itself."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Dict, NamedTuple, Optional, Tuple

import numpy as np

from . import _core
from ._maps import as_map, as_matches, point_arrays
from ._meshes import as_arrays, as_shape
from ._options import check_options, select, takes_options
from ._progress import shows_progress
from ._types import ArrayLike, MapLike, MeshLike, PathLike, Progress, TrueMapLike, TruthLike


@takes_options("geodesics")
@shows_progress
def geodesic_distances(
    mesh: MeshLike,
    sources: ArrayLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> np.ndarray:
    """Geodesic distances from each of `sources`, one vertex or a list of S, to all N vertices.

    Returns a float32 array of shape (S, N), or (N) for one source, in units of the coordinates;
    infinite where a vertex is not connected. O(S N log N).
    """
    check_options(options, "geodesics", function="geodesic_distances")
    rows = np.atleast_1d(np.asarray(sources))
    run = _core.RunOptions(threads, progress)
    fields = _core.geodesic_distances(*as_arrays(mesh), rows, options, run)
    return fields[0] if np.ndim(sources) == 0 else fields


@takes_options("geodesics")
@shows_progress
def geodesic_diameter(
    mesh: MeshLike, *, threads: Optional[int] = None, progress: Progress = None, **options
) -> float:
    """The largest geodesic distance between two connected vertices, in units of the coordinates,
    from below, exact to .5 % as a rule."""
    check_options(options, "geodesics", function="geodesic_diameter")
    return _core.geodesic_diameter(
        *as_arrays(mesh), options, _core.RunOptions(threads, progress)
    )


@takes_options("geodesics")
@shows_progress
def farthest_points(
    mesh: MeshLike,
    count: int,
    first: int = 0,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> np.ndarray:
    """At most `count` vertices, evenly spread: `first`, then always the one farthest from those
    before it. Returns an array of vertex indices. O(N log N)."""
    check_options(options, "geodesics", function="farthest_points")
    if count < 1:
        raise ValueError("count: expected at least 1")
    run = _core.RunOptions(threads, progress)
    return _core.farthest_points(*as_arrays(mesh), count, first, options, run)


@takes_options("saliency")
@shows_progress
def integral_geodesic_distance(
    mesh: MeshLike, *, threads: Optional[int] = None, progress: Progress = None, **options
) -> np.ndarray:
    """Mean geodesic distance of each vertex from the whole surface, over the largest geodesic
    distance: (N) values in [0, 1], large at extremities, NaN off the surface that is matched."""
    check_options(options, "saliency", function="integral_geodesic_distance")
    return _core.integral_geodesic_distance(
        as_shape(mesh, threads=threads)._core, options, _core.RunOptions(threads, progress)
    )


@takes_options("saliency")
@shows_progress
def gaussian_curvature(
    mesh: MeshLike, *, threads: Optional[int] = None, progress: Progress = None, **options
) -> np.ndarray:
    """Smoothed Gaussian curvature at each vertex times the surface's area: (N) values, NaN off the
    surface that is matched."""
    check_options(options, "saliency", function="gaussian_curvature")
    return _core.gaussian_curvature(
        as_shape(mesh, threads=threads)._core, options, _core.RunOptions(threads, progress)
    )


@shows_progress
def sample_bases(
    mesh: MeshLike,
    radius: float,
    order: Optional[ArrayLike] = None,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> np.ndarray:
    """Vertices no two of which are within geodesic distance `radius`, in units of the coordinates,
    and within `radius` of one of which every vertex lies. Candidates are taken in `order`, an
    array of all vertices of the surface; by default the extremities come first. Returns an array
    of vertex indices in the order of selection."""
    shape = as_shape(mesh, threads=threads)
    if order is None:
        saliency = integral_geodesic_distance(shape, threads=threads)
        order = np.argsort(-saliency, kind="stable")[: np.count_nonzero(shape.on_surface)]
    run = _core.RunOptions(threads, progress)
    return _core.sample_bases(shape._core, radius, np.asarray(order), run)


@takes_options("paper")
@shows_progress
def sample_jointly(
    source: MeshLike,
    target: MeshLike,
    level: int,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> Tuple[np.ndarray, np.ndarray]:
    """The base vertices of both meshes at a level, from 0, of the paper's method: two arrays of
    vertex indices in the order of selection."""
    check_options(options, "paper", function="sample_jointly")
    return _core.sample_jointly(
        as_shape(source, threads=threads)._core,
        as_shape(target, threads=threads)._core,
        level,
        options,
        _core.RunOptions(threads, progress),
    )


class Distortion(NamedTuple):
    """Isometric distortion, with distances relative to each surface's largest geodesic."""

    #: D_iso, the mean over all matches.
    mean: float
    #: d_iso-dagger, the maximum over all matches.
    maximum: float
    #: d_iso of each match, NaN where a vertex is off the surface that is matched.
    per_match: np.ndarray

    def __repr__(self):
        return (
            f"<isomatch.Distortion: mean {self.mean:.3g} and maximum {self.maximum:.3g} of "
            f"{len(self.per_match)} matches>"
        )


class Orientation(NamedTuple):
    """Whether a map turns the surface over, as a left-right flip does."""

    #: "preserves", "reverses", "undecided" or "not oriented".
    verdict: str
    #: Share of landmarks around which orientation is preserved, in [0, 1].
    preserved_share: float
    #: Mean sign of all triples of landmarks, in [-1, 1].
    mean_sign: float
    #: Landmarks that had an opinion.
    votes: int


@takes_options("distortion")
@shows_progress
def isometric_distortion(
    source: MeshLike,
    target: MeshLike,
    matches: ArrayLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> Distortion:
    """How far matches are from preserving geodesic distances (the paper's Equations 1, 2 and 4).

    `matches` is a map (N) from source vertices to target vertices, -1 where there is none, or an
    array (K, 2) of source and target vertices. Returns a `Distortion`.
    """
    check_options(options, "distortion", function="isometric_distortion")
    return Distortion(
        *_core.isometric_distortion(
            as_shape(source, threads=threads)._core,
            as_shape(target, threads=threads)._core,
            as_matches(matches),
            options,
            _core.RunOptions(threads, progress),
        )
    )


@takes_options("orientation")
@shows_progress
def map_orientation(
    source: MeshLike,
    target: MeshLike,
    matches: ArrayLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> Orientation:
    """Whether `matches`, in the forms of `isometric_distortion`, preserve or reverse orientation.
    Returns an `Orientation`."""
    check_options(options, "orientation", function="map_orientation")
    return Orientation(
        *_core.map_orientation(
            as_shape(source, threads=threads)._core,
            as_shape(target, threads=threads)._core,
            as_matches(matches),
            options,
            _core.RunOptions(threads, progress),
        )
    )


def read_vts(path: PathLike) -> np.ndarray:
    """Reads a .vts file, which numbers vertices from 1: an array of vertex indices from 0, -1 where
    it says 0, no vertex."""
    return np.array(_core.read_vts(os.fsencode(path)), dtype=np.int64)


def _vertices(truth, mesh):
    if not isinstance(truth, (str, os.PathLike)):
        return np.asarray(truth)
    vertices = len(mesh.on_surface)
    return np.array(_core.read_ground_truth(os.fsencode(truth), vertices), dtype=np.int64)


def _is_lists(gt):
    """Whether it is a list of vertices for each mesh. A list of pairs of numbers is not."""
    if isinstance(gt, tuple):
        return len(gt) in (2, 3)
    return isinstance(gt, list) and len(gt) in (2, 3) and all(
        isinstance(part, (str, os.PathLike, np.ndarray)) or np.size(part) > 2 for part in gt
    )


def as_truth(gt, source, target):
    """A ground truth in any form as arrays for the source, the target, and the target under the
    left-right symmetry, empty where there is none."""
    nothing = np.zeros(0, np.int64)
    if gt is None:
        return nothing, nothing, nothing
    if _is_lists(gt):
        meshes = (source, target, target)
        return (*(_vertices(*given) for given in zip(gt, meshes)), nothing)[:3]
    matches = as_matches(gt)
    if matches.ndim != 2 or matches.shape[1] != 2:
        raise ValueError("gt: expected a map (N) or two lists of corresponding vertices")
    return matches[:, 0], matches[:, 1], nothing


def as_true_map(gt_map, source, target):
    """A truth for every source vertex as the core takes it: nothing, vertices, or faces and
    weights."""
    if gt_map is None:
        return ()
    if isinstance(gt_map, (str, os.PathLike)):
        return _core.read_true_map(os.fsencode(gt_map), source._core, target._core)
    return point_arrays(gt_map)


class ErrorCurve(NamedTuple):
    """How many errors are small: what papers plot."""

    #: Errors, evenly spaced from 0.
    thresholds: np.ndarray
    #: Share of the errors that are at most as large, in [0, 1].
    shares: np.ndarray

    def __repr__(self):
        return (
            f"<isomatch.ErrorCurve: {self.shares[-1]:.1%} of errors are at most "
            f"{self.thresholds[-1]:g}>"
        )


def error_curve(errors: ArrayLike, maximum: float = 0.25, points: int = 100) -> ErrorCurve:
    """The cumulative curve of errors, at `points` thresholds up to `maximum`. NaN is left out; if
    nothing else is there, all shares are NaN. The field plots geodesic errors over sqrt(area) up to
    .25, as `evaluate` gives them. O(N log N)."""
    measured = np.asarray(errors, dtype=np.float64).ravel()
    measured = np.sort(measured[~np.isnan(measured)])
    thresholds = np.linspace(0, maximum, points)
    counts = np.searchsorted(measured, thresholds, side="right").astype(float)
    shares = counts / len(measured) if len(measured) > 0 else np.full(points, np.nan)
    return ErrorCurve(thresholds, shares)


@takes_options("truth", "distortion")
@shows_progress
def evaluate(
    source: MeshLike,
    target: MeshLike,
    correspondence: MapLike,
    gt: TruthLike = None,
    *,
    gt_map: TrueMapLike = None,
    per_vertex: bool = False,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> Dict[str, Any]:
    """How good a correspondence is: what `isomatch eval --json` prints, as a dictionary, but for
    the numbering of a file.

    Parameters
    ----------
    source, target
        Meshes in any form that `Shape` takes.
    correspondence
        A map (N) from source vertices to target vertices, -1 where there is none; an array (K, 2)
        of source and target vertices; or, for points on triangles, a tuple of an array (N) of
        target faces, -1 where there is none, and an array (N, 3) of barycentric weights, or an
        object that has both as `triangles` and `barycentric`.
    gt
        Ground truth: a map (N) or pairs (K, 2) as above; or a tuple or list of two lists of
        corresponding vertices, arrays or files as in docs/formats.md such as .vts, of the source
        and of the target, and maybe a third one of the target under its left-right symmetry, -1 (0
        in a .vts file) where a mesh lacks a point.
    gt_map
        Ground truth of every source vertex, for shapes that are partial: a map (N), -1 where the
        target has no counterpart; points on triangles as above; or a file of either.
    per_vertex
        Also give the error of each source vertex and the curve of these errors. All are computed,
        whatever `max_samples` says.

    Returns
    -------
    dict
        `matches`; `d_iso_over_max_geodesic`; `target_hit`: shares of vertices and area;
        `orientation`; with a truth `ground_truth`: errors over sqrt(area) of the target, and
        `overlap`, by template points; with `gt_map` `ground_truth_map`: errors on the overlap, and
        `overlap`, by area of the source: `iou` of the parts that the map and the truth match,
        `unmatched_precision` and `unmatched_recall`, each None where its denominator is 0,
        `matched_share` and `truly_matched_share`. With `per_vertex` `ground_truth` has also
        `per_vertex`, an array (N) of errors over sqrt(area), NaN where a vertex has no truth or no
        match, the mean where it has several; and `curve`, an `ErrorCurve` of these. The same goes
        for `ground_truth_map`, and for `symmetric_ground_truth`, if there is a third list.
    """
    check_options(options, "truth", "distortion", function="evaluate")
    source, target = as_shape(source, threads=threads), as_shape(target, threads=threads)
    text, *errors = _core.evaluate(
        source._core,
        target._core,
        as_map(correspondence),
        as_truth(gt, source, target),
        as_true_map(gt_map, source, target),
        per_vertex,
        select(options, "truth"),
        select(options, "distortion"),
        _core.RunOptions(threads, progress),
    )
    figures = json.loads(text)
    names = "ground_truth", "symmetric_ground_truth", "ground_truth_map"
    for name, of_vertices in zip(names, errors):
        if of_vertices is not None:
            figures[name].update(per_vertex=of_vertices, curve=error_curve(of_vertices))
    return figures


@dataclass(frozen=True, repr=False)
class SynthShape:
    """A made-up creature in a pose. Entry i of the ground truths of two poses is a matching pair of
    vertices."""

    #: (N, 3) coordinates; hip to shoulder is 1.
    vertices: np.ndarray
    #: (M, 3) vertex indices.
    faces: np.ndarray
    #: (N, 3) place of each vertex on the rest pose; mirroring negates x.
    rest: np.ndarray
    #: (5000) vertex of each template point; -1 where it was removed.
    ground_truth: np.ndarray
    #: (5000) vertex of each template point's mirror image; -1 where it was removed.
    symmetric_ground_truth: np.ndarray

    def __repr__(self):
        return (
            f"<isomatch.SynthShape of {len(self.vertices)} vertices and {len(self.faces)} faces>"
        )


@takes_options("synth")
@shows_progress
def synthesize(
    *, threads: Optional[int] = None, progress: Progress = None, **options
) -> SynthShape:
    """Makes a mesh with known correspondence to every other pose of the same seed. Returns a
    `SynthShape`, which can be used as a mesh."""
    check_options(options, "synth", function="synthesize")
    return SynthShape(**_core.synthesize(options, _core.RunOptions(threads, progress)))
