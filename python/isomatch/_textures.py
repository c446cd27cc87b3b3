# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Files of meshes with what they look like."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import List

import numpy as np

from . import _core
from ._meshes import as_arrays
from ._types import ArrayLike, MeshLike, PathLike


@dataclass(frozen=True, repr=False)
class TexturedMesh:
    """A mesh and what its faces are covered with. It can be used as a mesh."""

    #: (N, 3) coordinates.
    vertices: np.ndarray
    #: (M, 3) vertex indices.
    faces: np.ndarray
    #: (T, 2) places in an image, (0, 0) its lower left and (1, 1) its upper right corner.
    coordinates: np.ndarray
    #: (M, 3) rows of `coordinates`, for the corners of each face; -1 for all three where it is
    #: not covered.
    corners: np.ndarray
    #: Names of materials.
    materials: List[str]
    #: (M) number of each face's material, -1 where it has none.
    face_material: np.ndarray

    def __repr__(self):
        return (
            f"<isomatch.TexturedMesh of {len(self.vertices)} vertices, {len(self.faces)} faces and "
            f"{len(self.materials)} materials>"
        )


def textured_parts(mesh):
    """A textured mesh as the core takes it."""
    return (
        *as_arrays(mesh),
        np.asarray(mesh.coordinates),
        np.asarray(mesh.corners),
        list(mesh.materials),
        np.asarray(mesh.face_material),
    )


def read_textured_mesh(path: PathLike) -> TexturedMesh:
    """Reads an .obj file with texture coordinates. Raises OSError, also if no face has any."""
    return TexturedMesh(**_core.read_textured_mesh(os.fsencode(path)))


def write_textured_mesh(path: PathLike, mesh: TexturedMesh, library: str = "") -> None:
    """Writes an .obj file that names `library`, if it is given, as its file of materials, which is
    not written. Raises OSError, and ValueError if the texture does not fit the mesh."""
    _core.write_textured_mesh(os.fsencode(path), textured_parts(mesh), os.fsencode(library))


def material_libraries(path: PathLike) -> List[str]:
    """The files of materials that an .obj file names, as it names them. Raises OSError."""
    return [os.fsdecode(name) for name in _core.material_libraries(os.fsencode(path))]


def read_vertex_colors(path: PathLike) -> np.ndarray:
    """Reads the vertex colours of a .ply file: (N, 3) red, green and blue in [0, 1]. Raises
    OSError, also if there are none."""
    return _core.read_vertex_colors(os.fsencode(path))


def write_colored_mesh(path: PathLike, mesh: MeshLike, colors: ArrayLike) -> None:
    """Writes a binary .ply file with (N, 3) colours in [0, 1] at the vertices, rounded to 8 bits.
    Raises OSError, and ValueError if mesh and colours do not fit together."""
    _core.write_colored_mesh(os.fsencode(path), *as_arrays(mesh), np.asarray(colors))
