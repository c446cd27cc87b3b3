# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Statistics of shapes whose points correspond."""

from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Optional

import numpy as np

from . import _core
from ._types import ArrayLike


@dataclass(frozen=True, repr=False, eq=False)
class ShapeModel:
    """A point distribution model of N shapes of P points: generalised Procrustes alignment, mean
    and K principal modes. Lengths are in units of the mean, which are those of the points that were
    given: their centroid size is kept on average."""

    #: (P, 3) points around the origin, turned about as the first of the shapes with the most points.
    mean: np.ndarray
    #: (K, P, 3) orthonormal, largest variance first. Modes without variance are left out.
    modes: np.ndarray
    #: (K) variance of the shapes along each mode, in squared units, summed over the points.
    variances: np.ndarray
    #: (N, K) place of each shape along each mode, in units, not in standard deviations.
    scores: np.ndarray
    #: (N, P, 3) the shapes moved, turned and, unless size was kept, scaled onto each other; what one
    #: lacks is as a model of the others has it.
    aligned: np.ndarray
    #: (N, 4, 4) what leads each shape there from its own coordinates, of homogeneous coordinates.
    alignments: np.ndarray
    #: (N, P, 3) the points in their own coordinates, those that a shape lacks as the model has them.
    completed: np.ndarray
    #: (K) share of the variance that the first 1, 2, ... K modes have.
    compactness: np.ndarray
    #: (K) mean distance of a shape that was left out from what the first modes of the others make
    #: of it, root mean square over the points; NaN of fewer than three shapes.
    generalisation: np.ndarray
    #: (K) mean distance of random shapes of the first modes from the nearest shape.
    specificity: np.ndarray

    def shape_at(self, deviations: ArrayLike) -> np.ndarray:
        """(P, 3) the shape at so many standard deviations along each of the first modes."""
        steps = np.atleast_1d(np.asarray(deviations, dtype=np.float64))
        if steps.ndim != 1 or len(steps) > len(self.modes):
            raise ValueError(f"deviations: expected one for each of {len(self.modes)} modes at most")
        lengths = steps * np.sqrt(self.variances[: len(steps)])
        return self.mean + np.tensordot(lengths, self.modes[: len(steps)], 1)

    def __repr__(self):
        return (
            f"<isomatch.ShapeModel of {len(self.scores)} shapes of {len(self.mean)} points: "
            f"{len(self.modes)} modes>"
        )


def shape_model(
    points: ArrayLike,
    present: Optional[ArrayLike] = None,
    *,
    keep_size: bool = False,
    modes: Optional[int] = None,
) -> ShapeModel:
    """Mean and principal modes of N shapes with P points that correspond, whatever found them.

    Parameters
    ----------
    points
        (N, P, 3) coordinates; point p is the same place of all shapes.
    present
        (N, P) booleans: which points a shape has. By default those that are not NaN.
    keep_size
        Whether size is a part of shape: then shapes are moved and turned but not scaled.
    modes
        Principal modes at most; N - 1 by default.

    Raises
    ------
    ValueError
        There are fewer than two shapes or three points, no shape has a point, a coordinate is not
        finite, or a shape has too few points to be aligned.
    """
    points = np.asarray(points, dtype=np.float64)
    if points.ndim != 3 or points.shape[2] != 3:
        raise ValueError(f"points: expected shape (N, P, 3), not {points.shape}")
    if present is None:
        present = ~np.isnan(points).any(axis=2)
    present = np.asarray(present, dtype=bool)
    return ShapeModel(**_core.shape_model(points, present, keep_size, _at_most(modes)))


def _at_most(modes):
    if modes is None:
        return -1
    if modes < 0:
        raise ValueError("modes: expected 0 or more")
    return operator.index(modes)
