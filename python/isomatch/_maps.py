# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Maps in all their forms, and files of them."""

from __future__ import annotations

import os
from typing import NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._meshes import as_arrays
from ._types import MapLike, MeshLike, PathLike
from ._warnings import warn


class Points(NamedTuple):
    """Points on the triangles of a mesh, one a row; it can be given as a map."""

    #: (K) the vertex nearest to each point, -1 where there is no point. None if a file of points
    #: was read without their mesh.
    vertices: Optional[np.ndarray]
    #: (K) the face of each point, -1 where there is none.
    triangles: np.ndarray
    #: (K, 3) barycentric weights of that face's corners, 0 where there is none.
    barycentric: np.ndarray

    def __repr__(self):
        there = np.count_nonzero(np.asarray(self.triangles) >= 0)
        return f"<isomatch.Points: {len(self.triangles)}, of which {there} on a triangle>"


def is_points(points):
    """Whether it is a pair of faces and weights."""
    return isinstance(points, (tuple, list)) and len(points) == 2 and np.ndim(points[1]) == 2


def point_arrays(points):
    """Vertices, or points on faces, as the core takes them."""
    if hasattr(points, "triangles"):
        return np.asarray(points.triangles), np.asarray(points.barycentric)
    if is_points(points):
        return tuple(np.asarray(array) for array in points)
    return (np.asarray(points),)


def as_pairs(pairs, name):
    """(K, 2) vertices as an array."""
    pairs = np.asarray(pairs)
    if pairs.ndim == 2 and pairs.shape[0] == 2 != pairs.shape[1]:
        raise ValueError(f"{name}: expected shape (N, 2), not {pairs.shape}; is it transposed?")
    return pairs


def as_matches(correspondence):
    """A map (N) from source vertices to target vertices, -1 where there is none, or (K, 2) pairs,
    as (K, 2) pairs."""
    matches = as_pairs(correspondence, "matches")
    if matches.ndim != 1:
        return matches
    if matches.dtype.kind not in "iu" and not np.array_equal(matches, np.floor(matches)):
        raise ValueError("a map holds integers")
    matched = np.flatnonzero(matches >= 0)
    return np.column_stack([matched, matches[matched]])


def as_map(correspondence):
    """A map in any form as the core measures it: pairs of vertices, or faces and weights."""
    arrays = point_arrays(correspondence)
    return arrays if len(arrays) == 2 else (as_matches(arrays[0]),)


def read_map(
    path: PathLike,
    source: Optional[MeshLike] = None,
    target: Optional[MeshLike] = None,
    *,
    one_based: Optional[bool] = None,
) -> Union[np.ndarray, Points]:
    """Reads a map in any format of docs/formats.md: .txt, .map, .vts, .bary.txt or .npz.

    Returns a target vertex for each source vertex, (N), -1 where there is none; `Points` if the
    file has points on triangles; or source and target vertices (K, 2) if it lists pairs. Each can
    be given wherever a function takes a map.

    Parameters
    ----------
    source, target
        Meshes, against which the file is checked if they are given. With the target, a text file
        that is numbered from 1 is recognised where it cannot be otherwise, and points have their
        nearest vertices.
    one_based
        Whether a text file is numbered from 1; found out, or else taken as from 0 with a
        `MatchWarning`, if it is not given. The numbering of .vts and .npz files is fixed.

    Raises
    ------
    OSError
        The file cannot be read, is malformed, or does not fit the meshes.
    """
    vertices = None if source is None else len(as_arrays(source)[0])
    onto = None if target is None else as_arrays(target)
    content = _core.read_map(os.fsencode(path), vertices, onto, one_based)
    if content.pop("assumed"):
        warn(f"{os.fspath(path)}: taken as numbered from 0; if it is not, say one_based=True")
    if "pairs" in content:
        return content["pairs"]
    if "triangles" in content:
        return Points(**{"vertices": None, **content})
    return content["vertices"]


def write_map(
    path: PathLike,
    source_to_target: MapLike,
    target: Optional[MeshLike] = None,
    *,
    one_based: bool = False,
) -> None:
    """Writes a map in a format of docs/formats.md that its ending tells: .txt, .map, .vts,
    .bary.txt or .npz. The file appears whole or not at all.

    Parameters
    ----------
    source_to_target
        A target vertex for each source vertex, (N), -1 where there is none; a tuple of an array (N)
        of target faces and an array (N, 3) of barycentric weights; or an object that has both as
        `triangles` and `barycentric`, such as a `Match` or `Points`.
    target
        The target, needed where vertices are to become points on triangles or the other way round.
    one_based
        Whether a text file is numbered from 1. A .vts file always is, an .npz file never.

    Raises
    ------
    OSError
        The file cannot be written.
    ValueError
        The map is none, or the format has no room for it.
    """
    arrays = point_arrays(source_to_target)
    points = arrays if len(arrays) == 2 else None
    onto = None if target is None else as_arrays(target)
    _core.write_map(os.fsencode(path), _vertices(source_to_target, arrays), points, onto, one_based)


def _vertices(given, arrays):
    if len(arrays) == 1:
        return arrays[0]
    vertices = getattr(given, "source_to_target", getattr(given, "vertices", None))
    return None if vertices is None else np.asarray(vertices)
