# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Matching a collection of shapes consistently."""

from __future__ import annotations

import functools
import operator
import os
from pathlib import Path
from typing import Dict, List, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _core
from ._maps import Points
from ._match import Fit, Map
from ._meshes import Shape, as_shape, write_mesh
from ._options import check_options, takes_options
from ._page import shown_in_a_notebook, written_or_returned
from ._progress import shows_progress
from ._shape_model import ShapeModel, _at_most, shape_model
from ._types import MeshLike, PathLike, Progress
from ._warnings import warn


class GroupPair(NamedTuple):
    """A pair of a group that was matched, and what became of it."""

    #: Indices of the shapes.
    source: int
    target: int
    #: How badly they fit: the energy by which maps are ranked, at unit area; NaN, as the next, if
    #: they have too little in common.
    cost: float
    #: How far cycles through its own map are from closing: mean distance, over sqrt(area) of the
    #: target.
    cycle_error: float
    #: What became of its map: "agrees" with those of the others, "runner-up" took its place, or it
    #: was "composed" of the maps of others.
    use: str


class Group:
    """The result of `group`: N shapes with the same P points on each. Wherever a method takes a
    shape, it takes its name or its index from 0."""

    #: Of each shape, all different.
    names: List[str]
    #: The shapes themselves.
    shapes: List[Shape]
    #: Index of the shape whose vertices are followed to all others.
    template: int
    #: (P) which vertex of the template each point is.
    template_vertices: np.ndarray
    #: (M, 3) the template's faces by numbers of points; those all of whose corners are points.
    template_faces: np.ndarray
    #: (N, P, 3) the points, in the coordinates of each file; NaN where a shape has no counterpart.
    #: Close to the surfaces, and triangles between them do not fold; `from_template` leads to the
    #: surfaces themselves.
    points: np.ndarray
    #: (N, P) booleans: whether it has one.
    present: np.ndarray
    #: (N, P, 3) the same and complete: what has no counterpart moves as what is around it. NaN of a
    #: shape that is not matched at all.
    registered_points: np.ndarray
    #: (N, P) how far apart the pairs of a shape say that a point lies: root mean square distance
    #: over sqrt(area) of the shape, NaN where it has no counterpart.
    spread: np.ndarray
    #: How far the map from the template to each shape can be trusted, and its grade: "good",
    #: "doubtful" or "poor".
    fits: List[Fit]
    grades: List[str]
    #: What was matched: the pairs of the template, then those of shapes that are alike.
    pairs: List[GroupPair]
    #: (N) mean cycle error of the pairs of each shape, over sqrt(area).
    cycle_errors: np.ndarray
    #: Whether size is a part of shape in `mean`, `model` and what is saved.
    keep_size: bool
    #: Wall-clock seconds of each stage.
    seconds: Dict[str, float]

    def __init__(self, core, shapes, names, keep_size):
        self._core = core
        self.names, self.shapes, self.keep_size = names, shapes, keep_size
        self.template = core.template
        self.template_vertices, self.template_faces = core.vertices, core.faces
        self.points = core.points
        self.present = ~np.isnan(self.points[:, :, 0])
        self.registered_points = core.registered
        self.spread = np.where(self.present, core.spread, np.float32(np.nan))
        self.fits = [Fit(**core.fit(k)) for k in range(len(names))]
        self.grades = [fit.grade for fit in self.fits]
        self.pairs = [GroupPair(*pair) for pair in core.pairs]
        self.cycle_errors = core.cycle_errors
        self.seconds = core.seconds

    def __getstate__(self):
        return self.shapes, self.names, self.keep_size, self._core.state

    def __setstate__(self, state):
        shapes, names, keep_size, core = state
        core = _core.group_of_state(_cores(shapes), _encoded(names), core)
        self.__init__(core, shapes, names, keep_size)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self):
        counts = ", ".join(
            f"{self.grades.count(grade)} {grade}" for grade in ("good", "doubtful", "poor")
        )
        return (
            f"<isomatch.Group of {len(self)} shapes with {len(self.template_vertices)} points, "
            f"template {self.names[self.template]}: {counts}>"
        )

    @property
    def warnings(self) -> List[str]:
        """A sentence for each reason to look twice: those of each shape, see `Shape.warnings`, and
        of each map from the template. `group` warned of the grave ones."""
        return self._of_shapes("warnings") + self._doubts()

    def _urgent_warnings(self):
        return self._of_shapes("urgent_warnings") + self._doubts()

    def _of_shapes(self, kind):
        return [
            f"{name}: {text}"
            for name, shape in zip(self.names, self.shapes)
            for text in getattr(shape._core, kind)
        ]

    def _doubts(self):
        return [
            f"{name}: {fit.grade} fit: {reason}"
            for name, fit in zip(self.names, self.fits)
            for reason in fit.reasons
        ]

    def map(self, source: Union[int, str], target: Union[int, str]) -> Map:
        """The map from one shape to another, through the template, so that maps around a cycle lead
        back to where they began."""
        source, target = self._index(source), self._index(target)
        return self._map(source, target, self._core.between(source, target))

    def from_template(self, target: Union[int, str]) -> Map:
        """The map from all vertices of the template to a shape."""
        target = self._index(target)
        return self._map(self.template, target, self._core.from_template(target))

    def to_template(self, source: Union[int, str]) -> Map:
        """The map from all vertices of a shape to the template."""
        source = self._index(source)
        return self._map(source, self.template, self._core.to_template(source))

    def _map(self, source, target, parts):
        meshes = self.shapes[source], self.shapes[target]
        return Map(meshes, parts["points"], parts["fit"], Points(**parts["inverse"]))

    def _index(self, shape):
        return _index(shape, self.names)

    def model(
        self, *, keep_size: Optional[bool] = None, modes: Optional[int] = None
    ) -> ShapeModel:
        """Mean, principal modes and scores of the shapes, see `shape_model`; `keep_size` as it was
        given to `group`, if it is not given here. Raises ValueError if a shape has too few
        points."""
        keep_size = self.keep_size if keep_size is None else keep_size
        return shape_model(self.points, self.present, keep_size=keep_size, modes=modes)

    @functools.cached_property
    def mean(self) -> np.ndarray:
        """(P, 3) the mean shape, around the origin."""
        return self.model().mean

    def save(
        self,
        folder: PathLike,
        *,
        modes: Optional[int] = None,
        all_maps: bool = False,
        report: bool = False,
    ) -> None:
        """Writes what `isomatch group -o FOLDER` writes, byte for byte but for times: points,
        meshes, maps, mean and modes, of which there are `modes` at most, without shapes that none
        of the others matches; what isomatch wrote into the folder before is replaced. Meshes that
        were given as arrays are written into it as shapes/NAME.ply. `all_maps` adds the maps
        between all shapes, `report` group.html, a page that shows the collection. Raises OSError,
        before anything is written also if a file would be replaced that isomatch did not write."""
        folder = os.fsencode(folder)
        arrays, paths = {}, []
        for name, shape in zip(_encoded(self.names), self.shapes):
            place = b"shapes/" + name + b".ply"
            paths.append(os.fsencode(shape.path or os.path.join(folder, place)))
            if not shape.path:
                arrays[place] = shape
        inputs = [os.fsencode(shape.path) for shape in self.shapes if shape.path]
        saved = _core.SavedGroup(
            folder,
            paths,
            inputs,
            list(arrays),
            self.keep_size,
            _at_most(modes),
            all_maps,
            report,
        )
        self._core.check_save(saved)
        for place, shape in arrays.items():
            path = os.path.join(folder, place)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            write_mesh(os.fsdecode(path), shape)
        self._core.save(saved, _core.RunOptions(None, None))

    def report(self, path: Optional[PathLike] = None) -> Optional[str]:
        """A page that shows the collection in 3D, complete in itself: written to `path` if it is
        given, otherwise returned as a string of HTML. Raises ValueError if isomatch was built
        without the page, and OSError, before any work, if `path` is not named .html, is one of the
        meshes' files or cannot be written."""
        return written_or_returned(
            lambda: self._core.page(self.keep_size, _core.RunOptions(None, None)), path, self.shapes
        )

    def _repr_html_(self):
        return shown_in_a_notebook(self, "isomatch group")


def _cores(shapes):
    return [shape._core for shape in shapes]


def _encoded(names):
    return [os.fsencode(name) for name in names]


def _index(shape, names):
    if isinstance(shape, str):
        if shape not in names:
            raise ValueError(f"no shape has the name {shape!r}")
        return names.index(shape)
    index = operator.index(shape)
    if not 0 <= index < len(names):
        raise ValueError(f"there is no shape {index}: they are numbered from 0 to {len(names) - 1}")
    return index


def _name(shape, number):
    path = shape.path if isinstance(shape, Shape) else shape
    return Path(path).stem if isinstance(path, (str, os.PathLike)) else f"shape{number}"


def _listed(shapes):
    if isinstance(shapes, (str, os.PathLike)):
        raise TypeError(f"shapes: expected a list of meshes, not {shapes!r}")
    return list(shapes)


def _names(shapes, names):
    if names is None:
        names = [_name(shape, number) for number, shape in enumerate(shapes)]
    elif isinstance(names, str) or not all(isinstance(name, str) for name in names):
        raise TypeError("names: expected a list of str")
    if len(names) != len(shapes):
        raise ValueError(f"names: {len(names)} for {len(shapes)} shapes")
    _core.check_shape_names(_encoded(names))
    return list(names)


def _as_shapes(meshes, names, threads):
    shapes = []
    for name, mesh in zip(names, meshes):
        try:
            shapes.append(as_shape(mesh, threads=threads))
        except (TypeError, ValueError) as error:
            raise type(error)(f"{name}: {error}") from None
    return shapes


def _wanted(template, names, neighbours, points, memory):
    if isinstance(memory, bool) or not isinstance(memory, (int, float)):
        raise TypeError(f"memory: expected GiB, not {memory!r}")
    for name, value in (("neighbours", neighbours), ("points", points), ("memory", memory)):
        if value is not None and not 0 <= value < float("inf"):
            raise ValueError(f"{name}: expected 0 or more, not {value!r}")
    index = -1 if template is None else _index(template, names)
    return _core.GroupWanted(
        b"" if template is None else os.fsencode(names[index]),
        index,
        -1 if neighbours is None else operator.index(neighbours),
        0 if points is None else operator.index(points),
        int(memory * 2**30),
    )


@takes_options("tracked")
@shows_progress
def group(
    shapes: Sequence[MeshLike],
    *,
    names: Optional[Sequence[str]] = None,
    template: Union[None, int, str] = None,
    neighbours: Optional[int] = None,
    points: Optional[int] = None,
    keep_size: bool = False,
    memory: float = 2.0,
    threads: Optional[int] = None,
    progress: Progress = None,
    **options,
) -> Group:
    """Matches a collection of shapes of the same kind: the same points on all of them, and maps
    between all that close every cycle. About N log N pairs are matched by the tracked method, and
    where one disagrees with the others, they overrule it.

    Parameters
    ----------
    shapes
        Two or more meshes in any form that `Shape` takes; they may be parts.
    names
        Of the shapes, all different; by default those of the files without endings, and shape0,
        shape1, ... of arrays, by their place in the list.
    template
        Name or index of the shape whose vertices are followed to all others; by default the one
        that is nearest to all others and not a part.
    neighbours
        Shapes most like it that each shape is matched with besides the template; 1.5 log2 N by
        default.
    points
        How many points, evenly spread over the template; all its vertices by default.
    keep_size
        Whether size is a part of shape in the statistics.
    memory
        For what matching keeps of shapes for other pairs, in GiB.
    threads
        Number of threads, by default as many as the machine has. Results do not depend on it.
    progress
        As in `match`.

    Returns
    -------
    Group

    Raises
    ------
    ValueError
        An option is out of range, two shapes have the same name, there are fewer than two, or one
        cannot be matched.
    OSError
        A file cannot be read.
    KeyboardInterrupt
        Ctrl-C, after a moment.

    Warns
    -----
    MatchWarning
        A mesh has a grave defect, or the map to a shape is not good. `Group.warnings` has these and
        the small ones.
    """
    check_options(options, "tracked", function="group")
    shapes = _listed(shapes)
    names = _names(shapes, names)
    wanted = _wanted(template, names, neighbours, points, memory)
    shapes = _as_shapes(shapes, names, threads)
    run = _core.RunOptions(threads, progress)
    core = _core.match_group(_cores(shapes), _encoded(names), wanted, options, run)
    result = Group(core, shapes, names, keep_size)
    for text in result._urgent_warnings():
        warn(text)
    return result
