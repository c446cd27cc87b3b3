# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Files of maps."""
import numpy as np
import pytest

import isomatch

MAP = np.array([2, -1, 0, 3])
SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]), np.array([[0, 1, 2], [1, 3, 2]])
POINTS = isomatch.Points(
    np.array([0, -1, 3]),
    np.array([0, -1, 1]),
    np.array([[0.5, 0.25, 0.25], [0, 0, 0], [0.1, 0.7, 0.2]]),
)


@pytest.mark.parametrize("ending", ["txt", "map", "npz"])
def test_vertices_come_back(tmp_path, ending):
    path = tmp_path / f"a.{ending}"
    isomatch.write_map(path, MAP)
    assert np.array_equal(isomatch.read_map(path), MAP)
    assert np.array_equal(isomatch.read_map(path, target=SQUARE), MAP)


def test_vts_files_number_from_one(tmp_path):
    isomatch.write_map(tmp_path / "a.vts", [0, 3, 3])
    assert (tmp_path / "a.vts").read_text() == "1\n4\n4\n"
    assert isomatch.read_map(tmp_path / "a.vts").tolist() == [0, 3, 3]
    with pytest.raises(ValueError, match="unmatched"):
        isomatch.write_map(tmp_path / "a.vts", MAP)


@pytest.mark.parametrize("ending", ["bary.txt", "npz"])
def test_points_come_back(tmp_path, ending):
    path = tmp_path / f"a.{ending}"
    isomatch.write_map(path, POINTS)
    back = isomatch.read_map(path, target=SQUARE)
    assert all(np.array_equal(a, b) for a, b in zip(back, POINTS))
    isomatch.write_map(path, (POINTS.triangles, POINTS.barycentric))
    assert isomatch.read_map(path).vertices is None


def test_forms_are_converted_with_the_target(tmp_path):
    isomatch.write_map(tmp_path / "a.bary.txt", MAP, SQUARE)
    back = isomatch.read_map(tmp_path / "a.bary.txt", target=SQUARE)
    assert np.array_equal(back.vertices, MAP)
    isomatch.write_map(tmp_path / "a.txt", POINTS[1:], SQUARE)
    assert np.array_equal(isomatch.read_map(tmp_path / "a.txt"), POINTS.vertices)
    with pytest.raises(ValueError, match="form of the map is not known"):
        isomatch.write_map(tmp_path / "a.bary.txt", MAP)
    with pytest.raises(ValueError, match="vertex 9 is out of range"):
        isomatch.write_map(tmp_path / "a.bary.txt", [9], SQUARE)
    with pytest.raises(ValueError, match="face 9 is out of range"):
        isomatch.write_map(tmp_path / "a.txt", ([9], [[1.0, 0, 0]]), SQUARE)


def test_numbering_is_found_told_or_assumed(tmp_path):
    path = tmp_path / "a.txt"
    isomatch.write_map(path, [0, 3], one_based=True)
    assert path.read_text() == "1\n4\n"
    assert isomatch.read_map(path, target=SQUARE).tolist() == [0, 3]
    assert isomatch.read_map(path, one_based=True).tolist() == [0, 3]
    with pytest.warns(isomatch.MatchWarning, match="a.txt: taken as numbered from 0") as caught:
        assert isomatch.read_map(path).tolist() == [1, 4]
    assert caught[0].filename == __file__


def test_pairs_are_read(tmp_path):
    (tmp_path / "a.txt").write_text("0 2 .5\n1 0 .25\n")
    assert isomatch.read_map(tmp_path / "a.txt").tolist() == [[0, 2], [1, 0]]


def test_maps_of_the_program_are_read_and_given(files, program, tracked, tmp_path):
    tracked.save(tmp_path / "out")
    path = tmp_path / "out" / "source_to_target.bary.txt"
    points = isomatch.read_map(path, tracked.source, tracked.target)
    assert np.array_equal(points.vertices, tracked.source_to_target)
    assert np.array_equal(points.barycentric, tracked.barycentric)
    truth = files / "source.vts", files / "target.vts"
    figures = isomatch.evaluate(tracked.source, tracked.target, points, truth)
    assert figures == tracked.evaluate(truth)
    isomatch.write_map(tmp_path / "ours.npz", tracked)
    program("convert", tmp_path / "out", tmp_path / "theirs.npz")
    assert (tmp_path / "ours.npz").read_bytes() == (tmp_path / "theirs.npz").read_bytes()


def test_bad_files_are_os_errors(tmp_path):
    (tmp_path / "a.txt").write_text("0\nx\n")
    with pytest.raises(OSError, match="a.txt: line 2"):
        isomatch.read_map(tmp_path / "a.txt")
    (tmp_path / "b.txt").write_text("0\n5\n")
    with pytest.raises(OSError, match="out of range"):
        isomatch.read_map(tmp_path / "b.txt", target=SQUARE)
    with pytest.raises(OSError, match="the source has 4"):
        isomatch.read_map(tmp_path / "b.txt", SQUARE)
    for name in ("absent.txt", "a.csv"):
        with pytest.raises(OSError, match=name):
            isomatch.read_map(tmp_path / name)
    with pytest.raises(OSError, match="a.csv"):
        isomatch.write_map(tmp_path / "a.csv", MAP)
