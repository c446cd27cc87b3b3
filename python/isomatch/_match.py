# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What comes out of matching two meshes."""

from __future__ import annotations

import functools
import os
import tempfile
from typing import Any, Dict, List, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._maps import Points
from ._meshes import Shape, write_mesh
from ._options import takes_options
from ._page import shown_in_a_notebook, written_or_returned
from ._stages import Distortion, evaluate, isometric_distortion
from ._transfer import Transfer
from ._types import Method, PathLike, Progress, TrueMapLike, TruthLike


class Hypothesis(NamedTuple):
    """A hypothesis of the tracked method that was judged."""

    #: Mean isometric distortion, over sqrt(area).
    distortion: float
    #: Local orientation in [-1, 1].
    orientation: float
    #: Elastic energy of a quick registration at unit area, by which hypotheses are ranked.
    coarse_energy: float


class Fit(NamedTuple):
    """Whether a map can be trusted, judged from the map and the two shapes alone. Shares are in
    [0, 1]; both shapes are scaled to unit area."""

    #: "good", "doubtful" or "poor".
    grade: str
    #: Why it is not good, a clause each.
    reasons: List[str]
    #: Mean of abs(log(s)), s the factor by which distances between neighbouring places change.
    stretch: float
    #: Share of the source around which that is above log(2): torn, folded or sent elsewhere.
    distorted: float
    #: Largest mean change of the distances from one place to all others.
    displacement: float
    #: Correlation of bumps and hollows with those where they go; 1 where there are none.
    relief: float
    #: Share of the target that is not reached, and of the source that has no image.
    unreached: float
    unmatched: float
    #: Share of the source that is turned over; None if a surface has no outside.
    reversed: Optional[float]


class Level(NamedTuple):
    """A level of the paper's method. Vertices are those of the meshes that were given."""

    #: Sampling radii, in units of the coordinates.
    source_radius: float
    target_radius: float
    #: Base vertices in the order of selection.
    source_bases: np.ndarray
    target_bases: np.ndarray
    #: (K, 2) source and target vertices in which every base vertex occurs, and d_iso of each.
    matches: np.ndarray
    distortion: np.ndarray
    #: The same before merging made it many-to-many: one match for each source base.
    many_to_one: np.ndarray
    many_to_one_distortion: np.ndarray
    #: Outliers that merging moved.
    outliers_moved: int

    def __repr__(self):
        return (
            f"<isomatch.Level of {len(self.source_bases)} source and {len(self.target_bases)} "
            f"target bases, mean distortion {self.distortion.mean():.3g}>"
        )


class Map:
    """A map from the source's vertices to points on the target, one of those that were found.
    Vertices are those of the meshes that were given, from 0."""

    #: The meshes.
    source: Shape
    target: Shape
    #: (N) target vertex of each source vertex, -1 where it is unmatched.
    source_to_target: np.ndarray
    #: (N) target face of each source vertex, -1 where it is unmatched.
    triangles: np.ndarray
    #: (N, 3) barycentric weights of that face's corners, 0 where it is unmatched.
    barycentric: np.ndarray
    #: (M) source vertex of each target vertex, -1 where it is unmatched; None with the paper's
    #: method, and where the result is from a folder that was saved without it.
    target_to_source: Optional[np.ndarray]
    #: (N, 3) the source's vertices in the target's pose and coordinates; None if the method does
    #: not register.
    registered_vertices: Optional[np.ndarray]
    #: As-rigid-as-possible energy of the registration, at unit area; None if there is none.
    energy: Optional[float]
    #: Mean distance of the registered source from the target, at unit area.
    distance: Optional[float]
    #: Whether it maps the mirror image of the source.
    mirrored: bool
    #: (N) how sure the point of each source vertex is, in [0, 1], 0 where it is unmatched: of those
    #: with .9 nine in ten are within .05 of the truth, over sqrt(area). None with the paper's method.
    confidence: Optional[np.ndarray]
    #: How far it can be trusted.
    fit: Fit

    def __init__(
        self,
        meshes,
        points,
        fit,
        inverse=None,
        registered_vertices=None,
        figures=None,
        confidence=None,
    ):
        self.source, self.target = meshes
        self._inverse = inverse
        self.target_to_source = inverse.vertices if inverse else None
        self.source_to_target = points["vertices"]
        self.triangles = points["triangles"]
        self.barycentric = points["barycentric"]
        self.registered_vertices = registered_vertices
        figures = figures or {}
        self.energy = figures.get("energy")
        self.distance = figures.get("distance")
        self.mirrored = figures.get("mirrored", False)
        self.confidence = confidence
        self.fit = Fit(**fit)

    def __repr__(self):
        return f"<isomatch.Map: {self._described()}>"

    def _described(self):
        matched = np.count_nonzero(self.source_to_target >= 0)
        energy = "" if self.energy is None else f", energy {self.energy:.3g}"
        return (
            f"{matched} of {len(self.source_to_target)} source vertices matched, "
            f"{self.fit.grade} fit{energy}"
        )

    @functools.cached_property
    def transfer(self) -> Transfer:
        """Carries what belongs to one mesh over to the other: `transfer(values)`, and methods for
        all else; see `Transfer`."""
        return Transfer(self.source, self.target, self, self._inverse)


class Match(Map):
    """The result of `match`: its best map, the other ones, and how they were found."""

    #: "tracked" or "paper".
    method: Method
    #: Other maps that are worth a look, best first.
    alternatives: List[Map]
    #: C1 / C2, with C the cost of the best map and of the best other one: near 1 where the choice is
    #: ambiguous, 0 if there was no other. It does not say how good the map is; `fit` does. None with
    #: the paper's method.
    ambiguity: Optional[float]
    #: (K, 2) those of the landmarks that a far better map does not satisfy; empty with the paper's
    #: method.
    contradicted_landmarks: np.ndarray
    #: Whether both surfaces tell outside from inside, so that mirrored maps were excluded. None
    #: with the paper's method.
    oriented: Optional[bool]
    #: What the shapes were taken for: "source" and "target" are "whole" or "part" (something may be
    #: missing beyond the boundary), "scale" is "same" (units) or "area";
    #: "source_cut" and "target_cut" tell whether parts that touch were taken apart. None with the
    #: paper's method.
    taken_for: Optional[Dict[str, Union[str, bool]]]
    #: Wall-clock seconds of each stage.
    seconds: Dict[str, float]

    def __init__(self, core, method, meshes, landmarks, landmark_file=None):
        maps = (
            _tracked_maps(core)
            if method == "tracked"
            else [{"points": core.points(), "fit": core.fit(0)}]
        )
        super().__init__(meshes, **maps[0])
        self._core = core
        self._landmarks, self._landmark_file = landmarks, landmark_file
        self.method = method
        self.alternatives = [Map(meshes, **parts) for parts in maps[1:]]
        self.ambiguity = core.ambiguity if method == "tracked" else None
        self.contradicted_landmarks = (
            core.contradicted_landmarks if method == "tracked" else np.empty((0, 2), np.int32)
        )
        self.oriented = core.oriented if method == "tracked" else None
        self.taken_for = core.taken_for if method == "tracked" else None
        self.seconds = core.seconds

    def __getstate__(self):
        return self.method, self.source, self.target, self._landmarks, self._core.state

    def __setstate__(self, state):
        method, source, target, landmarks, core = state
        of_state = {"tracked": _core.tracked_of_state, "paper": _core.paper_of_state}[method]
        core = of_state(source._core, target._core, core)
        self.__init__(core, method, (source, target), landmarks)

    @property
    def warnings(self) -> List[str]:
        """A sentence for each reason to look twice: those of both meshes, see `Shape.warnings`, and
        those of the choice among maps. `match` warned of the grave ones."""
        return self._of_meshes("warnings") + self._doubts()

    def _urgent_warnings(self):
        return self._of_meshes("urgent_warnings") + self._doubts()

    def _of_meshes(self, kind):
        return [
            f"{name}: {text}"
            for name, mesh in (("source", self.source), ("target", self.target))
            for text in getattr(mesh._core, kind)
        ]

    def _doubts(self):
        fit = [f"{self.fit.grade} fit: {reason}" for reason in self.fit.reasons]
        return fit + (self._core.doubts if self.method == "tracked" else [])

    @functools.cached_property
    def correspondence(self) -> np.ndarray:
        """(K, 2) source and target vertices: the many-to-many relation in which every vertex of
        both surfaces occurs."""
        return self._core.correspondence()

    @functools.cached_property
    def levels(self) -> List[Level]:
        """A `Level` for each level of the paper's method; empty with the tracked method."""
        if self.method != "paper":
            return []
        return [_level(**level) for level in self._core.levels]

    @functools.cached_property
    def hypotheses(self) -> List[Hypothesis]:
        """A `Hypothesis` for each that was judged, best first; empty with the paper's method."""
        if self.method != "tracked":
            return []
        return [Hypothesis(*figures) for figures in self._core.hypotheses]

    @takes_options("distortion")
    def distortion(
        self, *, threads: Optional[int] = None, progress: Progress = None, **options
    ) -> Distortion:
        """Isometric distortion of `source_to_target`, see `isometric_distortion`."""
        return isometric_distortion(
            self.source,
            self.target,
            self.source_to_target,
            threads=threads,
            progress=progress,
            **options,
        )

    @takes_options("truth", "distortion")
    def evaluate(
        self,
        gt: TruthLike = None,
        *,
        gt_map: TrueMapLike = None,
        per_vertex: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
        **options,
    ) -> Dict[str, Any]:
        """How good the map is, against the ground truths `gt` and `gt_map` if they are given, and
        with `per_vertex` the error of each source vertex; see `evaluate`."""
        points = (self.triangles, self.barycentric)
        return evaluate(
            self.source,
            self.target,
            points if self.method == "tracked" else self.source_to_target,
            gt,
            gt_map=gt_map,
            per_vertex=per_vertex,
            threads=threads,
            progress=progress,
            **options,
        )

    def save(
        self, folder: PathLike, *, target_to_source: bool = False, report: bool = False
    ) -> None:
        """Writes what `isomatch match -o FOLDER` writes, byte for byte but for times, for `load` to
        read; what isomatch wrote into the folder before is replaced. Meshes that were given as arrays are written into
        it as source.ply and target.ply, landmarks as landmarks.txt. `target_to_source` adds the
        inverse map of the tracked method, `report` a page that shows the result. Raises OSError,
        before anything is written also if a file would be replaced that isomatch did not write."""
        if target_to_source and self.method != "tracked":
            raise ValueError("target_to_source: the paper's method makes no inverse map")
        if target_to_source and self.target_to_source is None:
            raise ValueError("target_to_source: the folder of this result did not have it")
        folder = os.fsencode(folder)
        os.makedirs(os.path.dirname(os.path.abspath(folder)), exist_ok=True)
        arrays = self._arrays_to_save()
        saved = _core.SavedAs(
            folder,
            os.fsencode(self.source.path or os.path.join(folder, b"source.ply")),
            os.fsencode(self.target.path or os.path.join(folder, b"target.ply")),
            self._saved_landmarks(folder),
            list(arrays),
            target_to_source,
            report,
        )
        self._core.check_save(saved)
        os.makedirs(folder, exist_ok=True)
        for name, write in arrays.items():
            write(os.fsdecode(os.path.join(folder, name)))
        self._core.save(saved, _core.RunOptions(None, None))

    def _saved_landmarks(self, folder):
        if self._landmark_file or len(self._landmarks) == 0:
            return os.fsencode(self._landmark_file or "")
        return os.path.join(folder, b"landmarks.txt")

    def _arrays_to_save(self):
        """What was given as arrays: names of files, and what writes each."""
        arrays = {}
        for name, shape in ((b"source.ply", self.source), (b"target.ply", self.target)):
            if not shape.path:
                arrays[name] = functools.partial(write_mesh, mesh=shape)
        if len(self._landmarks) > 0 and not self._landmark_file:
            arrays[b"landmarks.txt"] = functools.partial(
                np.savetxt, X=self._landmarks, fmt="%d", encoding="ascii"
            )
        return arrays

    def report(self, path: Optional[PathLike] = None) -> Optional[str]:
        """A page that shows the result in 3D, complete in itself: written to `path` if it is
        given, otherwise returned as a string of HTML. Raises ValueError if isomatch was built
        without the page, and OSError, before any work, if `path` is not named .html, is one of the
        meshes' files or cannot be written."""
        return written_or_returned(self._page, path, (self.source, self.target))

    def _page(self):
        with tempfile.TemporaryDirectory() as folder:
            self.save(folder, report=True)
            with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
                return file.read()

    def _repr_html_(self):
        return shown_in_a_notebook(self, "isomatch report")

    def __repr__(self):
        return f"<isomatch.Match by the {self.method} method: {self._described()}>"


def _tracked_maps(core):
    """The parts of each map, best first."""
    return [
        {
            "points": core.points(number),
            "fit": core.fit(number),
            "inverse": Points(**core.inverse_points(number)) if core.has_inverse else None,
            "registered_vertices": core.registered(number),
            "figures": core.figures(number),
            "confidence": core.confidence(number)[0],
        }
        for number in range(core.num_maps)
    ]


def _level(matches, many_to_one, **rest):
    return Level(
        matches=matches[0],
        distortion=matches[1],
        many_to_one=many_to_one[0],
        many_to_one_distortion=many_to_one[1],
        **rest,
    )
