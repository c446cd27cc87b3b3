# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Matching two meshes."""

from __future__ import annotations

import os
from typing import Optional, Union

import numpy as np

from . import _core
from ._maps import as_pairs
from ._match import Match
from ._meshes import as_shape
from ._options import check_options, takes_options
from ._progress import shows_progress
from ._types import ArrayLike, Geodesics, MeshLike, Method, PathLike, Progress
from ._warnings import warn


def _as_landmarks(landmarks, source, target):
    """(L, 2) vertices, and the file that they are from."""
    if isinstance(landmarks, (str, os.PathLike)):
        vertices = len(source.on_surface), len(target.on_surface)
        return _core.read_landmarks(os.fsencode(landmarks), *vertices), os.fspath(landmarks)
    if landmarks is None:
        return np.zeros((0, 2), np.int64), None
    return as_pairs(landmarks, "landmarks"), None


def _match_tracked(source, target, landmarks, options, run):
    return _core.match_tracked(source._core, target._core, landmarks, options, run)


def _match_paper(source, target, landmarks, options, run):
    if len(landmarks) > 0:
        raise ValueError("landmarks: the paper's method takes none")
    return _core.match_paper(source._core, target._core, source.geodesics, options, run)


_METHODS = {"tracked": _match_tracked, "paper": _match_paper}


def _check_method(method):
    if not isinstance(method, str):
        raise TypeError(
            f"method: expected 'tracked' or 'paper', not {type(method).__name__}; a mesh is one "
            "argument, as in match((vertices, faces), (vertices, faces))"
        )
    if method not in _METHODS:
        raise ValueError(f"method: expected 'tracked' or 'paper', not {method!r}")


@takes_options("tracked", "paper")
@shows_progress
def match(
    source: MeshLike,
    target: MeshLike,
    method: Method = "tracked",
    landmarks: Union[None, ArrayLike, PathLike] = None,
    *,
    geodesics: Geodesics = "w20",
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> Match:
    """Finds the correspondence between two triangle meshes of the same thing.

    Parameters
    ----------
    source, target
        Meshes in any form that `Shape` takes: the path of a file, a tuple (vertices, faces), an
        object that has both, or a `Shape`.
    method
        "tracked": a point on the target for every source vertex, and the source in the target's
        pose; "paper": the many-to-many matching of Sahillioglu and Yemez (2011), level by level.
    landmarks
        (L, 2) source and target vertices that must match, or a file with such a pair a line; for
        the tracked method.
    geodesics
        "w20", "w10" or "edges", see `Shape`, which keeps its own; for the paper's method and for
        what is measured.
    threads
        Number of threads, by default as many as the machine has. Results do not depend on it.
    progress
        True for a bar, by tqdm if it is installed; or called as `progress(fraction, stage)` with
        fraction in [0, 1]. What it raises ends the matching and is raised here.

    Returns
    -------
    Match

    Raises
    ------
    ValueError
        An option is out of range, a mesh cannot be matched, or no correspondence was found.
    OSError
        A file cannot be read.
    RuntimeError
        A solver failed.
    KeyboardInterrupt
        Ctrl-C, after a moment. Other Python threads go on meanwhile.

    Warns
    -----
    MatchWarning
        A file was read in part, a mesh has a grave defect, or the choice among maps is ambiguous.
        `Match.warnings` has these and the small ones.
    """
    _check_method(method)
    check_options(options, method, function=f"match(method={method!r})", methods=_METHODS)
    source = as_shape(source, geodesics, threads)
    target = as_shape(target, geodesics, threads)
    pairs, file = _as_landmarks(landmarks, source, target)
    run = _core.RunOptions(threads, progress)
    core = _METHODS[method](source, target, pairs, options, run)
    result = Match(core, method, (source, target), pairs, file)
    for text in result._urgent_warnings():
        warn(text)
    return result
