# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Types of what functions take."""

import os
from typing import Any, Callable, Optional, Tuple, Union

from numpy.typing import ArrayLike

PathLike = Union[str, "os.PathLike[str]"]
#: A path, a tuple (vertices, faces), a Shape, or another object with vertices and faces.
MeshLike = Union[PathLike, Tuple[ArrayLike, ArrayLike], Any]
#: Called with the fraction of the work and the name of the stage.
Progress = Optional[Callable[[float, str], Any]]
#: A map (N), pairs (K, 2), faces (N) and barycentric weights (N, 3), or an object that has both as
#: `triangles` and `barycentric`.
MapLike = Union[ArrayLike, Tuple[ArrayLike, ArrayLike], Any]
#: None, a map (N), or corresponding vertices: two or three arrays or .vts files.
TruthLike = Union[None, ArrayLike, Tuple[Union[ArrayLike, PathLike], ...]]
