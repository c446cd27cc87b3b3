# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Results that were saved, read again."""

from __future__ import annotations

import os
from typing import Optional

from . import _core
from ._match import Match
from ._meshes import Shape
from ._progress import shows_progress
from ._types import PathLike, Progress


@shows_progress
def load(
    folder: PathLike,
    source: Optional[PathLike] = None,
    target: Optional[PathLike] = None,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Match:
    """The result in a folder that `isomatch match -o` or `Match.save` wrote.

    It is what the match gave, but for what the folder does not have. Without `target_to_source`
    when it was saved, `target_to_source` is None, and `transfer` inverts the map. Base vertices of
    one level of the paper's method are in the order of their numbers, and `seconds` includes the
    reading of the files.

    Parameters
    ----------
    source, target
        Mesh files, if they are not where they were when they were matched. Meshes that were given
        as arrays are in the folder.
    threads
        Number of threads, by default as many as the machine has.
    progress
        As in `match`.

    Raises
    ------
    OSError
        A file is missing, malformed, or not one of this match; the message names it.
    """
    places = (os.fsencode(place) if place is not None else b"" for place in (source, target))
    saved = _core.Folder(os.fsencode(folder), *places)
    source, target = (
        Shape(os.fsdecode(path), saved.geodesics, threads=threads, progress=progress)
        for path in (saved.source, saved.target)
    )
    read = {"tracked": saved.tracked, "paper": saved.paper}[saved.method]
    return Match(read(source._core, target._core), saved.method, (source, target), saved.landmarks)
