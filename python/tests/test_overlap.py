# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Truths for every vertex, with vertices that have no counterpart."""

import numpy as np
import pytest

import isomatch


def corners(sheet, vertices):
    """Vertices, -1 for none, as points on triangles."""
    faces = sheet[1]
    triangles, weights = np.full(len(vertices), -1), np.zeros((len(vertices), 3))
    for k, vertex in enumerate(vertices):
        if vertex >= 0:
            triangles[k] = np.flatnonzero((faces == vertex).any(axis=1))[0]
            weights[k] = faces[triangles[k]] == vertex
    return triangles, weights


@pytest.fixture(scope="module")
def parts():
    """Maps of the sheet to itself that end after row 10 and begin at row 5."""
    truth, found = np.arange(441), np.arange(441)
    truth[11 * 21 :] = -1
    found[: 5 * 21] = -1
    return truth, found


def test_overlap_is_that_of_areas(sheet, parts):
    truth, found = parts
    figures = isomatch.evaluate(sheet, sheet, found, gt_map=truth)["ground_truth_map"]
    overlap = figures["overlap"]
    assert overlap["iou"] == pytest.approx(6 / 20)
    assert overlap["matched_share"] == pytest.approx(15.5 / 20)
    assert overlap["truly_matched_share"] == pytest.approx(10.5 / 20)
    assert overlap["unmatched_precision"] == overlap["unmatched_recall"] == 0
    assert figures["error_over_sqrt_area"]["samples"] == 6 * 21
    assert figures["error_over_sqrt_area"]["maximum"] == 0
    whole = isomatch.evaluate(sheet, sheet, np.arange(441), gt_map=np.arange(441))
    assert whole["ground_truth_map"]["overlap"]["unmatched_recall"] is None


def test_truths_of_every_form_are_the_same(sheet, parts, tmp_path):
    truth, found = parts
    expected = isomatch.evaluate(sheet, sheet, found, gt_map=truth)
    points = corners(sheet, truth)
    np.savetxt(tmp_path / "a.txt", truth)
    np.savetxt(tmp_path / "a.vts", truth + 1)
    isomatch.write_map(tmp_path / "a.npz", truth)
    isomatch.write_map(tmp_path / "a.bary.txt", points)
    names = "a.txt", "a.vts", "a.npz", "a.bary.txt"
    given = [points, isomatch.Points(None, *points), truth.tolist(), str(tmp_path / "a.txt")]
    for gt_map in given + [tmp_path / name for name in names]:
        assert isomatch.evaluate(sheet, sheet, found, gt_map=gt_map) == expected


def test_points_are_measured_from_points(sheet):
    triangles, weights = corners(sheet, np.arange(441))
    weights[:] = 0.5, 0.25, 0.25
    points = triangles, weights
    figures = isomatch.evaluate(sheet, sheet, points, gt_map=points)["ground_truth_map"]
    assert figures["point_error_over_sqrt_area"]["maximum"] == 0
    assert figures["point_d_grd_over_max_geodesic"]["maximum"] == 0
    assert figures["error_over_sqrt_area"]["mean"] > 0


def test_errors_of_vertices_are_those_of_the_overlap(sheet, parts):
    truth, found = parts[0], parts[1].copy()
    found[7 * 21] += 2
    figures = isomatch.evaluate(sheet, sheet, found, gt_map=truth, per_vertex=True)
    errors = figures["ground_truth_map"]["per_vertex"]
    assert np.array_equal(np.isnan(errors), (truth < 0) | (found < 0))
    assert errors[7 * 21] == pytest.approx(0.1, rel=1e-5)
    assert figures["ground_truth_map"]["curve"].shares[0] == pytest.approx(125 / 126)


def test_template_points_that_the_target_lacks(sheet, parts, tmp_path):
    truth, found = parts
    figures = isomatch.evaluate(sheet, sheet, found, (np.arange(441), truth), per_vertex=True)
    overlap = figures["ground_truth"]["overlap"]
    assert overlap["iou"] == pytest.approx(6 / 21)
    assert figures["ground_truth"]["template_points_on_surfaces"] == 11 * 21
    assert np.count_nonzero(~np.isnan(figures["ground_truth"]["per_vertex"])) == 6 * 21
    np.savetxt(tmp_path / "a.vts", np.arange(441) + 1)
    np.savetxt(tmp_path / "b.vts", truth + 1)
    files = tmp_path / "a.vts", tmp_path / "b.vts"
    assert np.array_equal(isomatch.read_vts(files[1]), truth)
    again = isomatch.evaluate(sheet, sheet, found, files)
    assert again["ground_truth"]["overlap"] == overlap


def test_results_take_it(tracked):
    figures = tracked.evaluate(gt_map=tracked)["ground_truth_map"]
    assert figures["overlap"]["iou"] == 1
    assert figures["point_error_over_sqrt_area"]["maximum"] == 0


@pytest.mark.parametrize(
    "gt_map, error, message",
    [
        (np.arange(440), ValueError, "440 points, but the mesh 441 vertices"),
        (np.full(441, 441), ValueError, "vertex 441 is out of range"),
        (np.full(441, -2), ValueError, "vertex -2 is out of range"),
        (np.zeros((441, 2), int), ValueError, "gt_map"),
        ((np.full(441, 800), np.tile([1, 0, 0], (441, 1))), ValueError, "face 800 is out of range"),
        ("absent.txt", OSError, "absent.txt"),
    ],
)
def test_bad_truths_are_refused(sheet, gt_map, error, message):
    with pytest.raises(error, match=message):
        isomatch.evaluate(sheet, sheet, np.arange(441), gt_map=gt_map)
