# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Carrying over by a map what belongs to a mesh."""

from __future__ import annotations

import os
from typing import Optional, Union

import numpy as np

from . import _core
from ._maps import Points, point_arrays
from ._meshes import Shape, as_shape
from ._options import check_options, takes_options
from ._progress import shows_progress
from ._textures import TexturedMesh, read_textured_mesh, textured_parts
from ._types import ArrayLike, MapLike, MeshLike, PathLike, Progress
from ._warnings import warn


def _whole_numbers_of_few_kinds(values):
    """Whether floats look like labels."""
    if values.dtype.kind != "f" or not np.array_equal(values, np.floor(values)):
        return False
    kinds = len(np.unique(values))
    return 1 < kinds <= len(values) // 10


def _warn_of_type(values):
    """Warns where the type of values (N) decides how they are carried, and they look otherwise."""
    if _whole_numbers_of_few_kinds(values):
        warn(
            "these floats look like labels, but are interpolated: say transfer.labels(...) for "
            "labels, transfer.values(...) for numbers"
        )
    elif values.dtype.kind in "iu" and len(np.unique(values)) > max(len(values) // 2, 10):
        warn(
            "these integers nearly all differ, but are carried as labels: say "
            "transfer.values(...) for numbers, transfer.labels(...) for labels"
        )


@takes_options("inversion")
@shows_progress
def invert_map(
    source: MeshLike,
    target: MeshLike,
    source_to_target: MapLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> Points:
    """The map of the other direction: for each target vertex the point of the source whose image
    is closest, and none where the source covers nothing near. `source_to_target` has the forms
    that `Transfer` takes. O((M + N) log N)."""
    check_options(options, "inversion", function="invert_map")
    return Points(
        **_core.invert_map(
            as_shape(source, threads=threads)._core,
            as_shape(target, threads=threads)._core,
            point_arrays(source_to_target),
            options,
            _core.RunOptions(threads, progress),
        )
    )


class Transfer:
    """Carries what belongs to the N vertices of the source over to the M vertices of the target.

    What is unmatched is marked, never invented: NaN, label -1, no point, no skinning weights, faces
    without texture. Only in poses it moves along with what is next to it.

    `result.transfer` is one that is ready; call it with values, or use its methods.

    Parameters
    ----------
    source, target
        Meshes in any form that `Shape` takes.
    source_to_target
        A target vertex for each source vertex, (N), -1 where there is none; a tuple of an array (N)
        of target faces and an array (N, 3) of barycentric weights; or an object that has both as
        `triangles` and `barycentric`, such as a `Match`.
    target_to_source
        The map of the other direction in the same forms; made by `invert_map` if it is missing.
    threads
        Number of threads, by default as many as the machine has. Results do not depend on it.
    progress
        True for a bar, or called as `progress(fraction, stage)` with fraction in [0, 1].

    Raises
    ------
    ValueError
        A map does not fit the meshes. So do methods for what does not fit the source.
    """

    #: The meshes.
    source: Shape
    target: Shape

    @shows_progress
    def __init__(
        self,
        source: MeshLike,
        target: MeshLike,
        source_to_target: MapLike,
        target_to_source: Optional[MapLike] = None,
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> None:
        self.source = as_shape(source, threads=threads)
        self.target = as_shape(target, threads=threads)
        if target_to_source is None:
            target_to_source = invert_map(
                self.source, self.target, source_to_target, threads=threads, progress=progress
            )
        self._maps = point_arrays(source_to_target), point_arrays(target_to_source)
        self._core = _core.Transfer(self.source._core, self.target._core, *self._maps)

    @property
    def reverse(self) -> Transfer:
        """The transfer from the target to the source."""
        return Transfer(self.target, self.source, *reversed(self._maps))

    @property
    def matched(self) -> np.ndarray:
        """(M) booleans: whether a target vertex lies on the source."""
        return self._maps[1][0] >= 0

    def _warn_if_nothing_is_matched(self):
        if not np.any(self.matched):
            warn(
                "no target vertex is matched, so nothing is carried over; a map by the paper's "
                "method needs all its levels"
            )

    def __getstate__(self):
        return self.source, self.target, self._maps

    def __setstate__(self, state):
        self.source, self.target, self._maps = state
        self._core = _core.Transfer(self.source._core, self.target._core, *self._maps)

    def __repr__(self):
        vertices = len(self.target.vertices)
        return (
            f"<isomatch.Transfer from {len(self.source.vertices)} to {vertices} vertices, "
            f"{np.count_nonzero(self.matched)} of which are matched>"
        )

    def __call__(self, values: ArrayLike) -> np.ndarray:
        """Carries integers of shape (N) as `labels` and everything else as `values`. The type
        decides, not what the numbers are: floats that look like labels, and integers that nearly
        all differ, are a `MatchWarning`. Say `labels` or `values` where it matters."""
        values = np.asarray(values)
        if values.ndim == 1:
            _warn_of_type(values)
            if values.dtype.kind in "iub":
                return self.labels(values)
        return self.values(values)

    def values(self, values: ArrayLike) -> np.ndarray:
        """Scalars (N), or vectors, colours and the like (N, ...), interpolated linearly over each
        source face: floats (M) or (M, ...), NaN where unmatched. Vectors are not turned with the
        surface."""
        values = np.asarray(values)
        if values.ndim == 0 or values.dtype.kind not in "fiub":
            raise ValueError("values: expected an array of numbers, a row for each source vertex")
        self._warn_if_nothing_is_matched()
        rows = values.reshape(len(values), -1).astype(np.float64, copy=False)
        return self._core.values(rows).reshape(-1, *values.shape[1:])

    def labels(self, labels: ArrayLike) -> np.ndarray:
        """Integers (N), -1 for none: (M) labels for which the corners of the source face vote with
        their weights, -1 where unmatched. Labels are never mixed."""
        self._warn_if_nothing_is_matched()
        labels = np.asarray(labels)
        return self._core.labels(labels.astype(np.int8) if labels.dtype.kind == "b" else labels)

    def landmarks(self, landmarks: MapLike) -> Points:
        """(L) source vertices, or source faces (L) and barycentric weights (L, 3) as a tuple or
        `Points`: the L points of the target where they lie."""
        return Points(**self._core.landmarks(point_arrays(landmarks)))

    def skin(self, weights: ArrayLike) -> np.ndarray:
        """Skinning weights (N, bones), interpolated: (M, bones). At each vertex the largest are
        kept, at most as many as a source vertex has at most, and sum to 1; all are 0 where
        unmatched."""
        return self._core.skin(np.asarray(weights))

    @takes_options("poses")
    @shows_progress
    def poses(
        self,
        frames: ArrayLike,
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
        **options,
    ) -> np.ndarray:
        """Frames of the source's animation (F, N, 3), or one pose (N, 3), as poses of the target,
        (F, M, 3) or (M, 3), by deformation transfer. Positions come out in the source's
        coordinates, in the target's size. What is unmatched follows. Give all frames at once: what
        they share is computed once."""
        check_options(options, "poses", function="poses")
        frames = np.asarray(frames)
        if frames.ndim not in (2, 3) or frames.shape[-2:] != (len(self.source.vertices), 3):
            raise ValueError(
                f"frames: expected shape (F, {len(self.source.vertices)}, 3), not {frames.shape}"
            )
        run = _core.RunOptions(threads, progress)
        rows = self._core.poses(frames.reshape(-1, 3), options, run)
        return rows.reshape(*frames.shape[:-2], -1, 3)

    @takes_options("texture")
    def texture(self, mesh: Union[TexturedMesh, PathLike], **options) -> TexturedMesh:
        """The source with a texture, or the .obj file of it: the target covered with the same
        images. New vertices, where faces are cut at seams, come after the target's own."""
        check_options(options, "texture", function="texture")
        if isinstance(mesh, (str, os.PathLike)):
            mesh = read_textured_mesh(mesh)
        return TexturedMesh(**self._core.texture(textured_parts(mesh), options))
