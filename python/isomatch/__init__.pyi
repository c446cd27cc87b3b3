# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
# Made by python/stubs/make_stubs.py; a test compares.
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from ._types import (
    ArrayLike,
    Geodesics,
    MapLike,
    MeshLike,
    Method,
    PathLike,
    Progress,
    TrueMapLike,
    TruthLike,
)

__version__: str

class Batch:
    folder: str
    table: List[Dict[str, Any]]
    @property
    def failed(self) -> List[Dict[str, Any]]: ...
    def __getitem__(
        self,
        name: str,
    ) -> Match: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...

class Group:
    names: List[str]
    shapes: List[Shape]
    template: int
    template_vertices: np.ndarray
    template_faces: np.ndarray
    points: np.ndarray
    present: np.ndarray
    registered_points: np.ndarray
    spread: np.ndarray
    fits: List[Fit]
    grades: List[str]
    pairs: List[GroupPair]
    cycle_errors: np.ndarray
    keep_size: bool
    seconds: Dict[str, float]
    def __len__(self) -> int: ...
    @property
    def warnings(self) -> List[str]: ...
    def map(
        self,
        source: Union[int, str],
        target: Union[int, str],
    ) -> Map: ...
    def from_template(
        self,
        target: Union[int, str],
    ) -> Map: ...
    def to_template(
        self,
        source: Union[int, str],
    ) -> Map: ...
    def model(
        self,
        *,
        keep_size: Optional[bool] = None,
        modes: Optional[int] = None,
    ) -> ShapeModel: ...
    @property
    def mean(self) -> np.ndarray: ...
    def save(
        self,
        folder: PathLike,
        *,
        modes: Optional[int] = None,
        all_maps: bool = False,
        report: bool = False,
    ) -> None: ...
    def report(
        self,
        path: Optional[PathLike] = None,
    ) -> Optional[str]: ...

class Map:
    source: Shape
    target: Shape
    source_to_target: np.ndarray
    triangles: np.ndarray
    barycentric: np.ndarray
    target_to_source: Optional[np.ndarray]
    registered_vertices: Optional[np.ndarray]
    energy: Optional[float]
    distance: Optional[float]
    mirrored: bool
    confidence: Optional[np.ndarray]
    fit: Fit
    @property
    def transfer(self) -> Transfer: ...

class Shape:
    geodesics: Geodesics
    def __init__(
        self,
        mesh: MeshLike,
        geodesics: Geodesics = 'w20',
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> None: ...
    @property
    def path(self) -> Optional[str]: ...
    @property
    def vertices(self) -> np.ndarray: ...
    @property
    def faces(self) -> np.ndarray: ...
    @property
    def on_surface(self) -> np.ndarray: ...
    @property
    def area(self) -> float: ...
    @property
    def max_geodesic(self) -> float: ...
    @property
    def warnings(self) -> List[str]: ...
    def diagnosis(self) -> Dict[str, Any]: ...

class ShapeModel:
    mean: np.ndarray
    modes: np.ndarray
    variances: np.ndarray
    scores: np.ndarray
    aligned: np.ndarray
    alignments: np.ndarray
    completed: np.ndarray
    compactness: np.ndarray
    generalisation: np.ndarray
    specificity: np.ndarray
    def shape_at(
        self,
        deviations: ArrayLike,
    ) -> np.ndarray: ...

class SynthShape:
    vertices: np.ndarray
    faces: np.ndarray
    rest: np.ndarray
    ground_truth: np.ndarray
    symmetric_ground_truth: np.ndarray

class TexturedMesh:
    vertices: np.ndarray
    faces: np.ndarray
    coordinates: np.ndarray
    corners: np.ndarray
    materials: List[str]
    face_material: np.ndarray

class Transfer:
    source: Shape
    target: Shape
    def __init__(
        self,
        source: MeshLike,
        target: MeshLike,
        source_to_target: MapLike,
        target_to_source: Optional[MapLike] = None,
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> None: ...
    @property
    def reverse(self) -> Transfer: ...
    @property
    def matched(self) -> np.ndarray: ...
    def __call__(
        self,
        values: ArrayLike,
    ) -> np.ndarray: ...
    def values(
        self,
        values: ArrayLike,
    ) -> np.ndarray: ...
    def labels(
        self,
        labels: ArrayLike,
    ) -> np.ndarray: ...
    def landmarks(
        self,
        landmarks: MapLike,
    ) -> Points: ...
    def skin(
        self,
        weights: ArrayLike,
    ) -> np.ndarray: ...
    def poses(
        self,
        frames: ArrayLike,
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
        same_rest_pose: bool = False,
    ) -> np.ndarray: ...
    def texture(
        self,
        mesh: Union[TexturedMesh, PathLike],
        *,
        cut_seams: bool = True,
    ) -> TexturedMesh: ...

class Distortion(NamedTuple):
    mean: float
    maximum: float
    per_match: np.ndarray

class ErrorCurve(NamedTuple):
    thresholds: np.ndarray
    shares: np.ndarray

class Fit(NamedTuple):
    grade: str
    reasons: List[str]
    stretch: float
    distorted: float
    displacement: float
    relief: float
    unreached: float
    unmatched: float
    reversed: Optional[float]

class GroupPair(NamedTuple):
    source: int
    target: int
    cost: float
    cycle_error: float
    use: str

class Hypothesis(NamedTuple):
    distortion: float
    orientation: float
    coarse_energy: float

class Level(NamedTuple):
    source_radius: float
    target_radius: float
    source_bases: np.ndarray
    target_bases: np.ndarray
    matches: np.ndarray
    distortion: np.ndarray
    many_to_one: np.ndarray
    many_to_one_distortion: np.ndarray
    outliers_moved: int

class Match(Map):
    method: Method
    alternatives: List[Map]
    ambiguity: Optional[float]
    contradicted_landmarks: np.ndarray
    oriented: Optional[bool]
    taken_for: Optional[Dict[str, Union[str, bool]]]
    seconds: Dict[str, float]
    @property
    def warnings(self) -> List[str]: ...
    @property
    def correspondence(self) -> np.ndarray: ...
    @property
    def levels(self) -> List[Level]: ...
    @property
    def hypotheses(self) -> List[Hypothesis]: ...
    def distortion(
        self,
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
        list_size: int = 500,
    ) -> Distortion: ...
    def evaluate(
        self,
        gt: TruthLike = None,
        *,
        gt_map: TrueMapLike = None,
        per_vertex: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
        max_samples: int = 20000,
        list_size: int = 500,
    ) -> Dict[str, Any]: ...
    def save(
        self,
        folder: PathLike,
        *,
        target_to_source: bool = False,
        report: bool = False,
    ) -> None: ...
    def report(
        self,
        path: Optional[PathLike] = None,
    ) -> Optional[str]: ...

class Orientation(NamedTuple):
    verdict: str
    preserved_share: float
    mean_sign: float
    votes: int

class Points(NamedTuple):
    vertices: Optional[np.ndarray]
    triangles: np.ndarray
    barycentric: np.ndarray

class MatchWarning(UserWarning):
    ...

def batch(
    pairs: Sequence[Tuple[PathLike, ...]],
    output: PathLike,
    *,
    client: Any = None,
    resume: bool = False,
    packed: bool = False,
    target_to_source: bool = False,
    memory: float = 1.0,
    threads: Optional[int] = None,
    shards: Optional[int] = None,
    retries: int = 3,
    progress: Progress = None,
    whole: bool = False,
    scale: str = 'auto',
    allow_reflection: bool = False,
    orientation: bool = True,
    elastic_judging: bool = True,
    refinement: bool = True,
    alternatives: int = 0,
) -> Batch: ...

def error_curve(
    errors: ArrayLike,
    maximum: float = 0.25,
    points: int = 100,
) -> ErrorCurve: ...

def evaluate(
    source: MeshLike,
    target: MeshLike,
    correspondence: MapLike,
    gt: TruthLike = None,
    *,
    gt_map: TrueMapLike = None,
    per_vertex: bool = False,
    threads: Optional[int] = None,
    progress: Progress = None,
    max_samples: int = 20000,
    list_size: int = 500,
) -> Dict[str, Any]: ...

def farthest_points(
    mesh: MeshLike,
    count: int,
    first: int = 0,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    arcs: str = 'visibility',
    window_angle: float = 20.0,
) -> np.ndarray: ...

def gaussian_curvature(
    mesh: MeshLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    integral_points: int = 150,
    curvature_scale: float = 0.03,
) -> np.ndarray: ...

def geodesic_diameter(
    mesh: MeshLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    arcs: str = 'visibility',
    window_angle: float = 20.0,
) -> float: ...

def geodesic_distances(
    mesh: MeshLike,
    sources: ArrayLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    arcs: str = 'visibility',
    window_angle: float = 20.0,
) -> np.ndarray: ...

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
    whole: bool = False,
    scale: str = 'auto',
    allow_reflection: bool = False,
    orientation: bool = True,
    elastic_judging: bool = True,
    refinement: bool = True,
    alternatives: int = 0,
) -> Group: ...

def integral_geodesic_distance(
    mesh: MeshLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    integral_points: int = 150,
    curvature_scale: float = 0.03,
) -> np.ndarray: ...

def invert_map(
    source: MeshLike,
    target: MeshLike,
    source_to_target: MapLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    max_distance: float = 0.05,
    normal_weight: float = 0.05,
) -> Points: ...

def isometric_distortion(
    source: MeshLike,
    target: MeshLike,
    matches: ArrayLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    list_size: int = 500,
) -> Distortion: ...

def load(
    folder: PathLike,
    source: Optional[PathLike] = None,
    target: Optional[PathLike] = None,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Match: ...

def map_orientation(
    source: MeshLike,
    target: MeshLike,
    matches: ArrayLike,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    landmarks: int = 200,
    min_distance: float = 0.05,
    max_distance: float = 0.25,
) -> Orientation: ...

def match(
    source: MeshLike,
    target: MeshLike,
    method: Method = 'tracked',
    landmarks: Union[None, ArrayLike, PathLike] = None,
    *,
    geodesics: Geodesics = 'w20',
    threads: Optional[int] = None,
    progress: Progress = None,
    whole: bool = False,
    scale: str = 'auto',
    allow_reflection: bool = False,
    orientation: bool = True,
    elastic_judging: bool = True,
    refinement: bool = True,
    alternatives: int = 0,
    integral_points: int = 150,
    curvature_scale: float = 0.03,
    radius_factor: float = 0.6,
    max_coarse_bases: int = 8,
    max_radius_ratio: float = 0.7,
    full_share: float = 0.9,
    max_patch_bases: int = 8,
    max_search_nodes: int = 100000,
    outlier_factor: float = 2.0,
    candidate_radius: float = 2.0,
    relaxation_rounds: int = 2,
    outlier_rounds: int = 4,
    list_size: int = 100,
    coarse_candidates: int = 24,
    candidate_levels: int = 4,
    keep_orientation: bool = False,
    levels: int = 100,
) -> Match: ...

def material_libraries(
    path: PathLike,
) -> List[str]: ...

def read_map(
    path: PathLike,
    source: Optional[MeshLike] = None,
    target: Optional[MeshLike] = None,
    *,
    one_based: Optional[bool] = None,
) -> Union[np.ndarray, Points]: ...

def read_mesh(
    path: PathLike,
) -> Tuple[np.ndarray, np.ndarray]: ...

def read_textured_mesh(
    path: PathLike,
) -> TexturedMesh: ...

def read_vertex_colors(
    path: PathLike,
) -> np.ndarray: ...

def read_vts(
    path: PathLike,
) -> np.ndarray: ...

def sample_bases(
    mesh: MeshLike,
    radius: float,
    order: Optional[ArrayLike] = None,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> np.ndarray: ...

def sample_jointly(
    source: MeshLike,
    target: MeshLike,
    level: int,
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    integral_points: int = 150,
    curvature_scale: float = 0.03,
    radius_factor: float = 0.6,
    max_coarse_bases: int = 8,
    max_radius_ratio: float = 0.7,
    full_share: float = 0.9,
    max_patch_bases: int = 8,
    max_search_nodes: int = 100000,
    outlier_factor: float = 2.0,
    candidate_radius: float = 2.0,
    relaxation_rounds: int = 2,
    outlier_rounds: int = 4,
    list_size: int = 100,
    coarse_candidates: int = 24,
    candidate_levels: int = 4,
    keep_orientation: bool = False,
    levels: int = 100,
) -> Tuple[np.ndarray, np.ndarray]: ...

def shape_model(
    points: ArrayLike,
    present: Optional[ArrayLike] = None,
    *,
    keep_size: bool = False,
    modes: Optional[int] = None,
) -> ShapeModel: ...

def synthesize(
    *,
    threads: Optional[int] = None,
    progress: Progress = None,
    shape: str = 'creature',
    vertices: int = 5000,
    pose: int = 0,
    seed: int = 1,
    cut: float = 0.0,
    holes: int = 0,
) -> SynthShape: ...

def write_colored_mesh(
    path: PathLike,
    mesh: MeshLike,
    colors: ArrayLike,
) -> None: ...

def write_map(
    path: PathLike,
    source_to_target: MapLike,
    target: Optional[MeshLike] = None,
    *,
    one_based: bool = False,
) -> None: ...

def write_mesh(
    path: PathLike,
    mesh: MeshLike,
) -> None: ...

def write_textured_mesh(
    path: PathLike,
    mesh: TexturedMesh,
    library: str = '',
) -> None: ...
