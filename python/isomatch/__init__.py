# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Dense correspondence between triangle meshes of the same thing in different poses.

    import isomatch

    result = isomatch.match("cat0.off", "cat1.off")
    result.source_to_target   # target vertex of each source vertex
    result.save("cats", report=True)

Wherever a function takes a mesh, it takes the path of a file, a tuple (vertices, faces) of arrays,
an object that has both, such as a mesh of trimesh, open3d or meshio, or a `Shape`. Vertices and
faces keep their order and are numbered from 0. Bad input raises ValueError, a bad file OSError, a
solver that fails RuntimeError; what is doubtful is a MatchWarning. Results are the same for any
number of threads, and can be copied and pickled.
"""

import os as _os

from ._requirements import check_python as _check_python

_check_python()

# Idle threads sleep instead of spinning, unless the user decided otherwise. OpenMP reads this once,
# when it is loaded; the environment of other programs stays as it was.
_spinning_decided = "OMP_WAIT_POLICY" in _os.environ
_os.environ.setdefault("OMP_WAIT_POLICY", "passive")
try:
    from . import _core
finally:
    if not _spinning_decided:
        del _os.environ["OMP_WAIT_POLICY"]

from ._batch import Batch, batch
from ._folders import load
from ._group import Group, GroupPair, group
from ._maps import Points, read_map, write_map
from ._match import Fit, Hypothesis, Level, Map, Match
from ._matching import match
from ._meshes import Shape, read_mesh, write_mesh
from ._shape_model import ShapeModel, shape_model
from ._stages import (
    Distortion,
    ErrorCurve,
    Orientation,
    SynthShape,
    error_curve,
    evaluate,
    farthest_points,
    gaussian_curvature,
    geodesic_diameter,
    geodesic_distances,
    integral_geodesic_distance,
    isometric_distortion,
    map_orientation,
    read_vts,
    sample_bases,
    sample_jointly,
    synthesize,
)
from ._textures import (
    TexturedMesh,
    material_libraries,
    read_textured_mesh,
    read_vertex_colors,
    write_colored_mesh,
    write_textured_mesh,
)
from ._transfer import Transfer, invert_map
from ._warnings import MatchWarning

__version__ = _core.version

__all__ = [
    "Batch",
    "Distortion",
    "ErrorCurve",
    "Fit",
    "Group",
    "GroupPair",
    "Hypothesis",
    "Level",
    "Map",
    "Match",
    "MatchWarning",
    "Orientation",
    "Points",
    "Shape",
    "ShapeModel",
    "SynthShape",
    "TexturedMesh",
    "Transfer",
    "batch",
    "error_curve",
    "evaluate",
    "farthest_points",
    "gaussian_curvature",
    "geodesic_diameter",
    "geodesic_distances",
    "integral_geodesic_distance",
    "group",
    "invert_map",
    "isometric_distortion",
    "load",
    "map_orientation",
    "match",
    "material_libraries",
    "read_map",
    "read_mesh",
    "read_textured_mesh",
    "read_vertex_colors",
    "read_vts",
    "sample_bases",
    "sample_jointly",
    "shape_model",
    "synthesize",
    "write_colored_mesh",
    "write_map",
    "write_mesh",
    "write_textured_mesh",
]
