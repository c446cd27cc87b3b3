# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
import os
import subprocess

import numpy as np
import pytest

import isomatch


@pytest.fixture(scope="session")
def pose1():
    return isomatch.synthesize(vertices=1000, pose=1, seed=2)


@pytest.fixture(scope="session")
def pose2():
    return isomatch.synthesize(vertices=1000, pose=2, seed=2)


@pytest.fixture(scope="session")
def tracked(pose1, pose2):
    return isomatch.match(pose1, pose2)


@pytest.fixture(scope="session")
def paper(pose1, pose2):
    return isomatch.match(pose1, pose2, method="paper", levels=4)


@pytest.fixture(scope="session")
def program():
    """Runs the command line program with arguments."""

    def run(*arguments):
        command = [os.environ["ISOMATCH_PROGRAM"], *map(str, arguments)]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout

    return run


@pytest.fixture(scope="session")
def files(pose1, pose2, tmp_path_factory):
    """The pair as files."""
    folder = tmp_path_factory.mktemp("pair")
    isomatch.write_mesh(folder / "source.off", pose1)
    isomatch.write_mesh(folder / "target.ply", pose2)
    for name, shape in (("source", pose1), ("target", pose2)):
        np.savetxt(folder / f"{name}.vts", shape.ground_truth + 1, fmt="%d")
    return folder


@pytest.fixture(scope="session")
def sheet():
    """A flat unit square of 20 by 20 cells; vertex (i, j) has number 21 j + i."""
    n = 20
    i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
    vertices = np.column_stack([i.ravel() / n, j.ravel() / n, np.zeros(i.size)])
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + n + 2])
    upper = np.column_stack([corner, corner + n + 2, corner + n + 1])
    return vertices, np.vstack([lower, upper])
