# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Meshes in the forms in which people have them."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any, Dict, List, Optional, Tuple

import numpy as np

from . import _core
from ._progress import shows_progress
from ._types import Geodesics, MeshLike, PathLike, Progress


# What trimesh, open3d, meshio and pyFM call them.
_VERTICES = "vertices", "points", "vertlist"
_FACES = "faces", "triangles", "facelist"


def _part(mesh, names):
    """What a mesh has under the first of these names, None if under none."""
    for name in names:
        part = mesh.get(name) if isinstance(mesh, Mapping) else getattr(mesh, name, None)
        if part is not None:
            return part
    return None


def _triangles(mesh):
    faces = _part(mesh, _FACES)
    return getattr(mesh, "cells_dict", {}).get("triangle") if faces is None else faces


def as_arrays(mesh):
    """(N, 3) coordinates and (M, 3) vertex indices of a mesh in any form."""
    if isinstance(mesh, (str, os.PathLike)):
        return _core.read_mesh(os.fsencode(mesh))
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return np.asarray(mesh[0]), np.asarray(mesh[1])
    vertices, faces = _part(mesh, _VERTICES), _triangles(mesh)
    if vertices is None or faces is None:
        hint = "; give both arrays as one" if isinstance(mesh, np.ndarray) else ""
        raise TypeError(
            "a mesh is the path of a file, a tuple (vertices, faces), or an object or dict that "
            f"has both, not {type(mesh).__name__}{hint}"
        )
    return np.asarray(vertices), np.asarray(faces)


class Shape:
    """A mesh, prepared for matching: its surface and, once they are needed, its geodesic graph,
    simplified copies and eigenfunctions.

    Wherever a function takes a mesh it takes a Shape, which saves the time of preparing it again, a
    third of that of a match. It can be copied and pickled; a copy prepares what it needs once more.

    Parameters
    ----------
    mesh
        The path of an OFF, OBJ, PLY, STL, glTF or MATLAB file; a tuple of an (N, 3) array of
        coordinates and an (M, 3) array of vertex indices from 0; or an object or dict with
        `vertices`, `points` or `vertlist` and `faces`, `triangles`, `facelist` or `cells_dict`,
        such as meshes of trimesh, open3d, meshio and pyFM.
    geodesics
        "w20" or "w10": straight lines across triangles, mean error .22 % and .06 %; "edges": along
        edges, as in the paper.
    threads
        Number of threads, by default as many as the machine has. Results do not depend on it.
    progress
        True for a bar, or called as `progress(fraction, stage)` with fraction in [0, 1].

    Raises
    ------
    ValueError
        The mesh has no face of positive area, or arrays have other shapes.
    OSError
        A file cannot be read.
    """

    #: "w20", "w10" or "edges", as given.
    geodesics: Geodesics

    @shows_progress
    def __init__(
        self,
        mesh: MeshLike,
        geodesics: Geodesics = "w20",
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> None:
        run = _core.RunOptions(threads, progress)
        if isinstance(mesh, (str, os.PathLike)):
            self._core = _core.load_shape(os.fsencode(mesh), geodesics, run)
        else:
            self._core = _core.make_shape(*as_arrays(mesh), geodesics, run)
        self.geodesics = geodesics

    @property
    def path(self) -> Optional[str]:
        """The file it was read from, None if it was made of arrays."""
        return os.fsdecode(self._core.path) or None

    @property
    def vertices(self) -> np.ndarray:
        """(N, 3) coordinates, a copy, in the order that they were given in."""
        return self._core.vertices

    @property
    def faces(self) -> np.ndarray:
        """(M, 3) vertex indices from 0, a copy."""
        return self._core.faces

    @property
    def on_surface(self) -> np.ndarray:
        """(N) booleans: whether a vertex is part of the surface that is matched, the largest
        component without degenerate faces."""
        return self._core.on_surface

    @property
    def area(self) -> float:
        """Area of the surface that is matched, in squared units of the coordinates."""
        return self._core.area

    @property
    def max_geodesic(self) -> float:
        """Largest geodesic distance on that surface, in units of the coordinates."""
        return self._core.max_geodesic

    @property
    def warnings(self) -> List[str]:
        """A sentence for each thing that reading the file left out, and for each defect of the
        mesh that matching works around."""
        return self._core.warnings

    def diagnosis(self) -> Dict[str, Any]:
        """What the mesh is made of, as a dictionary; what `isomatch info --json` prints."""
        return json.loads(self._core.diagnosis_json())

    def __getstate__(self):
        return {
            "path": self._core.path,
            "vertices": self._core.vertices,
            "faces": self._core.faces,
            "read_report": self._core.read_report,
            "geodesics": self.geodesics,
        }

    def __setstate__(self, state):
        self._core = _core.restore_shape(**state)
        self.geodesics = state["geodesics"]

    def __repr__(self):
        return (
            f"<isomatch.Shape of {len(self.vertices)} vertices and {len(self.faces)} faces"
            f"{', ' + self.path if self.path else ''}>"
        )


def as_shape(mesh, geodesics="w20", threads=None):
    """`mesh` itself if it is a Shape, otherwise a Shape made of it."""
    return mesh if isinstance(mesh, Shape) else Shape(mesh, geodesics, threads=threads)


def read_mesh(path: PathLike) -> Tuple[np.ndarray, np.ndarray]:
    """Reads an OFF, OBJ, PLY, STL, glTF or MATLAB file: an (N, 3) array of coordinates and an
    (M, 3) array of vertex indices from 0, both in the file's order. Raises OSError."""
    return _core.read_mesh(os.fsencode(path))


def write_mesh(path: PathLike, mesh: MeshLike) -> None:
    """Writes a mesh in any form as .off, .obj, .ply (binary), .glb, .gltf or .mat. Coordinates survive
    exactly, but glTF rounds them to 32 bits; the file appears whole or not at all. Raises OSError,
    and ValueError for a mesh that is none."""
    _core.write_mesh(os.fsencode(path), *as_arrays(mesh))
