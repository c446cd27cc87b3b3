# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Types of what functions take."""

import os
from typing import Any, Callable, List, Literal, Mapping, Tuple, Union

from numpy.typing import ArrayLike

PathLike = Union[str, "os.PathLike[str]"]
#: How `match` works.
Method = Literal["tracked", "paper"]
#: See `Shape`.
Geodesics = Literal["w20", "w10", "edges"]
#: A path, vertices and faces, a Shape, or another object with vertices and faces.
MeshLike = Union[
    PathLike, Tuple[ArrayLike, ArrayLike], List[ArrayLike], Mapping[str, ArrayLike], Any
]
#: True for a bar, or what is called with the fraction of the work and the name of the stage.
Progress = Union[None, bool, Callable[[float, str], Any]]
#: A map (N), pairs (K, 2), faces (N) and barycentric weights (N, 3), or an object that has both as
#: `triangles` and `barycentric`.
MapLike = Union[ArrayLike, Tuple[ArrayLike, ArrayLike], Any]
#: None, a map (N), faces (N) and weights (N, 3), an object that has both, or a file.
TrueMapLike = Union[None, PathLike, ArrayLike, Tuple[ArrayLike, ArrayLike], Any]
#: None, a map (N), or corresponding vertices: two or three arrays or .vts files.
TruthLike = Union[
    None, ArrayLike, Tuple[Union[ArrayLike, PathLike], ...], List[Union[ArrayLike, PathLike]]
]
