# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Nearest vertices after the best similarity, as a map between rigid shapes."""

import numpy as np
from scipy.spatial import cKDTree

from partial_scores import map_of_vertices

POINTS = 3000  # Points of each shape that are aligned.
KEPT = .8  # Share of the nearest points that an alignment looks at.
STEPS = 60


def points_on(surface):
    """Evenly spread over the area."""
    generator = np.random.default_rng(0)
    areas = surface.face_areas
    faces = generator.choice(len(areas), POINTS, p=areas / areas.sum())
    weights = generator.dirichlet(np.ones(3), POINTS)
    return (weights[:, :, None] * surface.vertices[surface.faces[faces]]).sum(1)


def frame(points):
    """Centre, principal axes as columns of a rotation, and size."""
    centre = points.mean(0)
    spread, axes = np.linalg.eigh(np.cov((points - centre).T))
    axes[:, 0] *= np.sign(np.linalg.det(axes))
    return centre, axes, np.sqrt(spread.sum())


def similarity(source, target):
    """Matrix and shift that bring the source's points nearest to the target's."""
    source_centre, target_centre = source.mean(0), target.mean(0)
    source, target = source - source_centre, target - target_centre
    u, values, v = np.linalg.svd(target.T @ source)
    signs = np.array([1, 1, np.sign(np.linalg.det(u @ v))])
    matrix = (u * signs) @ v * (values * signs).sum() / (source ** 2).sum()
    return matrix, target_centre - matrix @ source_centre


def refined(motion, source, tree):
    """The motion after steps of alignment with the nearest points, and what distance remains."""
    for _ in range(STEPS):
        distance, nearest = tree.query(source @ motion[0].T + motion[1])
        kept = np.argsort(distance)[:int(KEPT * len(source))]
        motion = similarity(source[kept], tree.data[nearest[kept]])
    distance = np.sort(tree.query(source @ motion[0].T + motion[1])[0])
    return motion, distance[:int(KEPT * len(source))].mean()


def alignment(source, target):
    """From the four ways in which the principal axes can be laid upon each other."""
    source_points, target_points = points_on(source), points_on(target)
    source_centre, source_axes, source_size = frame(source_points)
    target_centre, target_axes, target_size = frame(target_points)
    tree = cKDTree(target_points)
    tried = []
    for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)):
        matrix = (target_axes * signs) @ source_axes.T * target_size / source_size
        tried.append(refined((matrix, target_centre - matrix @ source_centre), source_points, tree))
    return min(tried, key=lambda result: result[1])[0]


def rigid_map(source, target):
    matrix, shift = alignment(source, target)
    used = np.unique(target.faces[np.isfinite(target.vertices[target.faces]).all((1, 2))])
    finite = np.isfinite(source.vertices).all(1)
    images = np.full(len(source.vertices), -1)
    moved = source.vertices[finite] @ matrix.T + shift
    images[finite] = used[cKDTree(target.vertices[used]).query(moved)[1]]
    return map_of_vertices(images, target)
