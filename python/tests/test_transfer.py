# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What is carried over by maps."""
import numpy as np
import pytest

import isomatch


def corner_mean(values, faces, points):
    """Values at points by numpy alone."""
    return np.einsum("nk,nk...->n...", points[1], values[faces[points[0]]])


@pytest.fixture(scope="module")
def points(sheet):
    """A random point of the sheet for each of its vertices."""
    random = np.random.default_rng(1)
    count = len(sheet[0])
    return random.integers(len(sheet[1]), size=count), random.dirichlet([1, 1, 1], count)


@pytest.fixture(scope="module")
def scattered(sheet, points):
    return isomatch.Transfer(sheet, sheet, np.arange(len(sheet[0])), points)


@pytest.fixture(scope="module")
def identity(sheet):
    return isomatch.Transfer(sheet, sheet, np.arange(len(sheet[0])))


@pytest.mark.parametrize("shape", [(), (1,), (3,), (2, 2)])
def test_values_are_interpolated(sheet, points, scattered, shape):
    values = np.random.default_rng(2).normal(size=(len(sheet[0]), *shape))
    carried = scattered.values(values)
    assert carried.shape == values.shape and carried.dtype == np.float64
    assert np.allclose(carried, corner_mean(values, sheet[1], points), rtol=0, atol=1e-14)
    assert np.array_equal(scattered(values), carried)


def test_views_are_carried_like_copies(sheet, scattered):
    vertices = sheet[0]
    assert np.array_equal(scattered(vertices[:, 1]), scattered(vertices)[:, 1])
    assert np.array_equal(scattered(np.asfortranarray(vertices)), scattered(vertices))
    bytes_ = (255 * vertices).astype(np.uint8)
    assert np.array_equal(scattered(bytes_), scattered(bytes_.astype(float)))


def test_labels_are_elected(sheet, points, scattered):
    labels = np.random.default_rng(3).integers(4, size=len(sheet[0]))
    votes = np.zeros((len(labels), 4))
    for corner in range(3):
        elected = labels[sheet[1][points[0], corner]]
        votes[np.arange(len(labels)), elected] += points[1][:, corner]
    assert np.array_equal(scattered(labels), votes.argmax(axis=1))
    assert np.array_equal(scattered(labels.astype(np.uint8)), scattered.labels(labels))
    halves = scattered(labels > 1)
    assert set(halves) == {0, 1}


def test_skinning_weights_are_blended(sheet, points, scattered):
    """With as many bones as there are, none is left out."""
    weights = np.random.default_rng(4).dirichlet([1, 1, 1], len(sheet[0]))
    carried = scattered.skin(weights)
    assert np.allclose(carried, corner_mean(weights, sheet[1], points), rtol=0, atol=1e-14)
    sparse = np.eye(5)[np.arange(len(weights)) % 5]
    carried = scattered.skin(sparse)
    assert np.array_equal(np.count_nonzero(carried, axis=1), np.ones(len(sparse)))
    assert np.array_equal(carried.sum(axis=1), np.ones(len(sparse)))


def test_landmarks_lie_where_the_map_says(sheet, points):
    count = len(sheet[0])
    transfer = isomatch.Transfer(sheet, sheet, points, np.arange(count))
    landmarks = transfer.landmarks([3, 200, 3])
    assert np.array_equal(landmarks.triangles, points[0][[3, 200, 3]])
    assert np.allclose(landmarks.barycentric, points[1][[3, 200, 3]], rtol=0, atol=1e-15)


def test_points_between_vertices_are_landmarks_too(sheet, identity):
    given = (np.array([5, 700]), np.array([[0.2, 0.3, 0.5], [0.5, 0.5, 0]]))
    landmarks = identity.landmarks(given)
    assert isinstance(landmarks, isomatch.Points)
    place = corner_mean(*sheet, landmarks[1:])
    assert np.allclose(place, corner_mean(*sheet, given), rtol=0, atol=1e-12)
    assert np.array_equal(identity.landmarks(landmarks).vertices, landmarks.vertices)


def test_poses_of_an_equal_mesh_are_followed(sheet, identity):
    vertices = sheet[0]
    bent = np.column_stack([np.sin(vertices[:, 0]), vertices[:, 1], np.cos(vertices[:, 0])])
    frames = np.stack([vertices, bent, bent + [0, 0, 1]])
    reports = []
    carried = identity.poses(frames, progress=lambda *report: reports.append(report))
    # A frame that is moved as a whole stays where the mesh that is matched stands.
    assert carried.shape == frames.shape
    for pose, frame in zip(carried, frames):
        moved = (pose - pose.mean(axis=0)) - (frame - frame.mean(axis=0))
        assert np.abs(moved).max() < 1e-6
    assert {stage for _, stage in reports} == {"poses"}
    assert np.array_equal(identity.poses(bent), carried[1])


def test_what_is_unmatched_is_marked(sheet, points):
    count = len(sheet[0])
    triangles = points[0].copy()
    triangles[:10] = -1
    transfer = isomatch.Transfer(sheet, sheet, np.full(count, -1), (triangles, points[1]))
    assert np.array_equal(transfer.matched, np.arange(count) >= 10)
    assert np.array_equal(np.isnan(transfer(sheet[0])).all(axis=1), ~transfer.matched)
    assert np.array_equal(transfer(np.zeros(count, int)) == -1, ~transfer.matched)
    assert np.array_equal(transfer.skin(np.ones((count, 1)))[:, 0], transfer.matched)
    assert np.array_equal(transfer.landmarks([1]).vertices, [-1])
    assert np.isfinite(transfer.poses(sheet[0])).all()


def test_a_map_is_inverted(sheet):
    relabelled = np.random.default_rng(5).permutation(len(sheet[0]))
    target = np.empty_like(sheet[0])
    target[relabelled] = sheet[0]
    inverse = isomatch.invert_map(sheet, (target, relabelled[sheet[1]]), relabelled)
    assert np.array_equal(inverse.vertices[relabelled], np.arange(len(relabelled)))
    nothing = isomatch.invert_map(sheet, sheet, np.full(len(sheet[0]), -1))
    assert np.all(nothing.triangles == -1)


@pytest.fixture(scope="module")
def textured(sheet):
    """The sheet with the image laid over it, in two materials, each with its own coordinates."""
    vertices, faces = sheet
    left = vertices[faces].mean(axis=1)[:, 0] < 0.5
    coordinates = np.vstack([vertices[:, :2] / 2, vertices[:, :2] / 2 + 0.5])
    return isomatch.TexturedMesh(
        vertices, faces, coordinates, np.where(left[:, None], faces, faces + len(vertices)),
        ["left", "right"], np.where(left, 0, 1),
    )


def test_a_texture_is_laid_over_an_equal_mesh(textured, identity):
    carried = identity.texture(textured)
    assert np.array_equal(carried.faces, textured.faces)
    assert carried.materials[:2] == textured.materials
    assert np.array_equal(carried.face_material, textured.face_material)
    ours, theirs = (mesh.coordinates[mesh.corners] for mesh in (carried, textured))
    assert np.allclose(ours, theirs, rtol=0, atol=1e-9)


def test_faces_are_cut_at_seams_or_kept(sheet, textured):
    """A coarser mesh of the square, with one face on both sides of the seam."""
    coarse = np.array([[0, 0, 0], [1.0, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]])
    corners = isomatch.Transfer(sheet, coarse, np.full(len(sheet[0]), -1), [0, 20, 420])
    kept = corners.texture(textured, cut_seams=False)
    assert np.array_equal(kept.faces, coarse[1])
    cut = corners.texture(textured)
    assert len(cut.faces) > 1 and np.array_equal(cut.vertices[:3], coarse[0])
    assert set(cut.face_material) == {0, 1}


def test_textures_are_read_and_written(textured, tmp_path):
    isomatch.write_textured_mesh(tmp_path / "sheet.obj", textured, "sheet.mtl")
    read = isomatch.read_textured_mesh(tmp_path / "sheet.obj")
    for name in ("vertices", "faces", "coordinates", "corners", "face_material"):
        ours, theirs = getattr(read, name), getattr(textured, name)
        if name == "corners":
            ours, theirs = read.coordinates[ours], textured.coordinates[theirs]
        elif name == "coordinates":
            continue
        assert np.array_equal(ours, theirs), name
    assert read.materials == textured.materials
    assert isomatch.material_libraries(tmp_path / "sheet.obj") == ["sheet.mtl"]
    isomatch.write_mesh(tmp_path / "sheet.ply", read)


def test_colors_are_read_and_written(sheet, tmp_path):
    colors = np.round(255 * np.random.default_rng(6).random(sheet[0].shape)) / 255
    isomatch.write_colored_mesh(tmp_path / "sheet.ply", sheet, colors)
    read = isomatch.read_vertex_colors(tmp_path / "sheet.ply")
    assert np.allclose(read, colors, rtol=0, atol=1e-12)


def test_a_match_carries_both_ways(tracked, pose1, pose2):
    """`rest` is the place on the creature that both poses are made of; an edge is .05 there."""
    gap = np.linalg.norm(tracked.transfer(pose1.rest) - pose2.rest, axis=1)
    back = np.linalg.norm(tracked.transfer.reverse(pose2.rest) - pose1.rest, axis=1)
    assert gap.mean() < 0.05 and back.mean() < 0.05
    right = (pose1.rest[:, 0] > 0).astype(int)
    assert np.mean(tracked.transfer(right) == (pose2.rest[:, 0] > 0)) > 0.95


def test_a_match_carries_poses(tracked, pose1):
    """The target in the source's pose comes to lie on the source."""
    posed = tracked.transfer.poses(pose1.vertices)
    beside = tracked.transfer(pose1.vertices)
    gap = (posed - posed.mean(axis=0)) - (beside - beside.mean(axis=0))
    assert np.linalg.norm(gap, axis=1).mean() < 0.05


def test_the_paper_method_carries_what_it_matched(pose1, pose2):
    result = isomatch.match(pose1, pose2, method="paper")
    carried = result.transfer(pose1.rest)
    known = np.isfinite(carried).all(axis=1)
    assert np.array_equal(known, result.transfer.matched) and known.mean() > 0.8


def test_the_program_carries_the_same(tracked, program, tmp_path, pose1):
    tracked.save(tmp_path / "result", target_to_source=True)
    labels = np.arange(len(pose1.vertices)) % 7
    np.savetxt(tmp_path / "labels.txt", labels, fmt="%d")
    program("transfer", tmp_path / "result", "--labels", tmp_path / "labels.txt",
            "-o", tmp_path / "carried.txt")
    assert np.array_equal(tracked.transfer(labels), np.loadtxt(tmp_path / "carried.txt"))
    np.savetxt(tmp_path / "values.txt", pose1.vertices, fmt="%.17g")
    program("transfer", tmp_path / "result", "--values", tmp_path / "values.txt",
            "-o", tmp_path / "carried.txt")
    assert np.allclose(tracked.transfer(pose1.vertices), np.loadtxt(tmp_path / "carried.txt"))


@pytest.mark.parametrize(
    "carry, message",
    [
        (lambda t: t(np.zeros(5)), "5 values for 441 source vertices"),
        (lambda t: t(np.zeros(5, int)), "5 values for 441 source vertices"),
        (lambda t: t("values"), "expected an array of numbers"),
        (lambda t: t.labels(np.full(441, 0.5)), "labels: expected integers"),
        (lambda t: t.landmarks([441]), "landmarks: vertex 441 is out of range"),
        (lambda t: t.skin(np.zeros(441)), "weights: expected two dimensions"),
        (lambda t: t.skin(np.full((441, 2), -1)), "skinning weight -1"),
        (lambda t: t.poses(np.zeros((2, 440, 3))), r"frames: expected shape \(F, 441, 3\)"),
        (lambda t: t.poses(np.full((441, 3), np.nan)), "frame"),
    ],
)
def test_what_does_not_fit_is_a_value_error(identity, carry, message):
    with pytest.raises(ValueError, match=message):
        carry(identity)


@pytest.mark.parametrize(
    "source_to_target, message",
    [
        (np.zeros(440, int), "440 points"),
        (np.full(441, 441), "vertex 441 is out of range"),
        (np.full(441, -2), "vertex -2 is out of range"),
        ((np.full(441, 800), np.full((441, 3), 1 / 3)), "face 800 is out of range"),
        ((np.zeros(441, int), np.ones((441, 3))), "do not sum to 1"),
    ],
)
def test_bad_maps_are_value_errors(sheet, source_to_target, message):
    with pytest.raises(ValueError, match=message):
        isomatch.Transfer(sheet, sheet, source_to_target)


def test_unknown_options_are_type_errors(identity, sheet):
    with pytest.raises(TypeError, match="its options are same_rest_pose"):
        identity.poses(sheet[0], rest=True)
