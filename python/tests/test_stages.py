# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
import json

import numpy as np
import pytest

import isomatch


def test_geodesics_on_a_flat_sheet_are_straight_lines(sheet):
    vertices, _ = sheet
    fields = isomatch.geodesic_distances(sheet, [0, 220])
    assert fields.shape == (2, 441) and fields.dtype == np.float32
    for source, field in zip((0, 220), fields):
        straight = np.linalg.norm(vertices - vertices[source], axis=1)
        assert np.all(field >= straight - 1e-6)
        # W20 errs by .22 % on irregular meshes; on a regular one all lines share few directions.
        assert np.mean(field - straight) < 0.01
    assert np.array_equal(isomatch.geodesic_distances(sheet, 220), fields[1])


def test_geodesics_along_edges_are_paths_of_edges(sheet):
    field = isomatch.geodesic_distances(sheet, 0, arcs="edges")
    assert field[20] == pytest.approx(1)
    assert field[440] == pytest.approx(np.sqrt(2), rel=1e-5)
    # Against the diagonals of the cells: along the sides.
    assert isomatch.geodesic_distances(sheet, 20, arcs="edges")[420] == pytest.approx(2)
    assert isomatch.geodesic_distances(sheet, 20, window_angle=5)[420] < 1.42


def test_distances_to_what_is_not_connected_are_infinite(sheet):
    vertices, faces = sheet
    lonely = np.vstack([vertices, [[5, 5, 5]]])
    assert np.isinf(isomatch.geodesic_distances((lonely, faces), 0)[-1])


def test_diameter_and_farthest_points(sheet):
    assert isomatch.geodesic_diameter(sheet) == pytest.approx(np.sqrt(2), rel=5e-3)
    # The opposite corner, then the other two, which are equally far.
    spread = isomatch.farthest_points(sheet, 4).tolist()
    assert spread[:2] == [0, 440] and set(spread[2:]) == {20, 420}
    assert len(isomatch.farthest_points(sheet, 1000, first=5)) == 441


def test_saliency(sheet, pose1):
    integral = isomatch.integral_geodesic_distance(sheet)
    assert integral.shape == (441,)
    assert np.linalg.norm(sheet[0][np.argmin(integral)] - [0.5, 0.5, 0]) < 0.1
    assert np.argmax(integral) in (0, 20, 420, 440)
    assert np.abs(isomatch.gaussian_curvature(sheet)).max() == pytest.approx(0, abs=1e-6)
    # Gauss-Bonnet: the mean of curvature times area is 4 pi on a closed surface of genus 0.
    curvature = isomatch.gaussian_curvature(pose1)
    triangles = pose1.vertices[pose1.faces]
    cross = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    share = np.zeros(len(pose1.vertices))
    np.add.at(share, pose1.faces, np.linalg.norm(cross, axis=1)[:, None] / 6)
    assert np.sum(curvature * share) / share.sum() == pytest.approx(4 * np.pi, rel=0.02)


def test_samples_cover_and_keep_their_distance(pose1):
    shape = isomatch.Shape(pose1)
    radius = shape.max_geodesic / 5
    bases = isomatch.sample_bases(shape, radius)
    fields = isomatch.geodesic_distances(pose1, bases)
    # Graphs of the surface and of the mesh may round differently.
    assert fields.min(axis=0).max() <= radius * 1.001
    between = fields[:, bases] + np.diag(np.full(len(bases), np.inf))
    assert between.min() > radius * 0.999
    saliency = isomatch.integral_geodesic_distance(shape)
    assert bases[0] == np.argmax(saliency)


def test_joint_sampling_is_that_of_the_method(pose1, pose2, paper):
    source, target = isomatch.sample_jointly(pose1, pose2, 2)
    assert np.array_equal(source, paper.levels[2].source_bases)
    assert np.array_equal(target, paper.levels[2].target_bases)


def test_identity_has_no_distortion_and_no_error(pose1):
    identity = np.arange(len(pose1.vertices))
    distortion = isomatch.isometric_distortion(pose1, pose1, identity)
    assert distortion.mean == 0 and distortion.maximum == 0
    assert np.array_equal(distortion.per_match, np.zeros(len(identity)))
    figures = isomatch.evaluate(pose1, pose1, identity, identity)
    assert figures["ground_truth"]["error_over_sqrt_area"]["mean"] == 0
    assert figures["target_hit"]["vertices"] == 1
    assert isomatch.map_orientation(pose1, pose1, identity).verdict == "preserves"


def test_a_mirrored_map_reverses_orientation(pose1):
    mirrored = (pose1.vertices * [-1, 1, 1], pose1.faces[:, ::-1])
    identity = np.arange(len(pose1.vertices))
    orientation = isomatch.map_orientation(pose1, mirrored, identity)
    assert orientation.verdict == "reverses" and orientation.preserved_share < 0.1


def test_distortion_stays_with_its_match(pose1):
    identity = np.arange(len(pose1.vertices))
    wrong = identity.copy()
    wrong[7] = isomatch.farthest_points(pose1, 2, first=7)[1]
    assert np.argmax(isomatch.isometric_distortion(pose1, pose1, wrong).per_match) == 7
    pairs = np.column_stack([identity, wrong])[::-1]
    reversed_pairs = isomatch.isometric_distortion(pose1, pose1, pairs)
    assert np.argmax(reversed_pairs.per_match) == len(identity) - 1 - 7


def test_evaluation_is_that_of_the_program(files, program, tracked):
    folder = files / "evaluated"
    tracked.save(folder)
    truth = (files / "source.vts", files / "target.vts")
    printed = program(
        "eval", files / "source.off", files / "target.ply", folder / "source_to_target.bary.txt",
        "--gt-source", truth[0], "--gt-target", truth[1], "--json",
    )
    figures = json.loads(printed)
    assert figures.pop("map_numbered_from") == 0
    assert tracked.evaluate(truth) == figures
    arrays = tuple(isomatch.read_vts(path) for path in truth)
    assert tracked.evaluate(arrays) == figures


def test_truths_are_numbered_as_their_ending_says(tmp_path, tracked):
    truth = np.flatnonzero(tracked.source_to_target >= 0), tracked.source_to_target
    truth = truth[0], truth[1][truth[0]]
    np.savetxt(tmp_path / "a.vts", truth[0] + 1, header="by numpy")
    np.savetxt(tmp_path / "b.txt", truth[1])
    assert np.array_equal(isomatch.read_vts(tmp_path / "a.vts"), truth[0])
    figures = tracked.evaluate((tmp_path / "a.vts", tmp_path / "b.txt"))
    assert figures == tracked.evaluate(truth)


def test_synth_is_that_of_the_program(tmp_path, program, pose1):
    program("synth", "--vertices", 1000, "--pose", 1, "--seed", 2, "-o", tmp_path / "a.off")
    vertices, faces = isomatch.read_mesh(tmp_path / "a.off")
    assert np.array_equal(vertices, pose1.vertices) and np.array_equal(faces, pose1.faces)
    assert np.array_equal(isomatch.read_vts(tmp_path / "a.vts"), pose1.ground_truth)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda m: isomatch.geodesic_distances(m, 441), "sources: vertex 441 is out of range"),
        (lambda m: isomatch.geodesic_distances(m, -1), "sources: vertex -1 is out of range"),
        (lambda m: isomatch.geodesic_distances(m, [0.5]), "sources: expected integers"),
        (lambda m: isomatch.geodesic_distances(m, 0, arcs="air"), "arcs"),
        (lambda m: isomatch.geodesic_distances(m, 0, window_angle=90), "angle"),
        (lambda m: isomatch.geodesic_distances(m, 0, threads=0), "threads"),
        (lambda m: isomatch.farthest_points(m, 0), "count"),
        (lambda m: isomatch.evaluate(m, m, np.arange(9), (np.arange(3), np.arange(4))), "points"),
        (lambda m: isomatch.evaluate(m, m, np.array([[0, 441]])), "vertex 441 is out of range"),
        (lambda m: isomatch.evaluate(m, m, (np.zeros(441, int), np.ones((441, 3)))), "sum to 1"),
        (lambda m: isomatch.synthesize(vertices=7), "vertices"),
    ],
)
def test_bad_arguments_are_value_errors(sheet, call, message):
    with pytest.raises(ValueError, match=message):
        call(sheet)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda m: isomatch.geodesic_distances(m, 0, angle=3), "geodesic_distances has no option 'angle'"),
        (lambda m: isomatch.geodesic_distances(m, 0, window_angle="x"), "window_angle"),
        (lambda m: isomatch.synthesize(vertices=1000.5), "vertices: expected int"),
    ],
)
def test_bad_keywords_are_type_errors(sheet, call, message):
    with pytest.raises(TypeError, match=message):
        call(sheet)
