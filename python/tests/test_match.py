# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
import json
import os
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

import isomatch
from isomatch import _core


def points(result, vertices, faces):
    """Where each source vertex lands."""
    return np.einsum("nk,nkd->nd", result.barycentric, vertices[faces[result.triangles]])


def test_a_shape_matched_to_itself_stays(pose1):
    result = isomatch.match(pose1, pose1)
    identity = np.arange(len(pose1.vertices))
    assert np.mean(result.source_to_target == identity) > 0.99
    moved = np.linalg.norm(result.registered_vertices - pose1.vertices, axis=1)
    assert moved.mean() < 0.01
    assert result.distortion().mean < 1e-3


def test_the_map_is_right(tracked, pose1, pose2):
    truth = (pose1.ground_truth, pose2.ground_truth)
    figures = tracked.evaluate(truth)["ground_truth"]
    # As in the tests of the program: an edge is .03.
    assert figures["point_error_over_sqrt_area"]["mean"] < 0.03
    assert tracked.evaluate((*truth, pose2.symmetric_ground_truth))["flipped"] is False


def test_forms_of_the_map_agree(tracked, pose1, pose2):
    n = len(pose1.vertices)
    assert tracked.source_to_target.shape == tracked.triangles.shape == (n,)
    assert tracked.barycentric.shape == tracked.registered_vertices.shape == (n, 3)
    assert np.allclose(tracked.barycentric.sum(axis=1), 1)
    nearest = pose2.faces[tracked.triangles][np.arange(n), tracked.barycentric.argmax(axis=1)]
    assert np.array_equal(nearest, tracked.source_to_target)
    landed = points(tracked, pose2.vertices, pose2.faces)
    assert np.linalg.norm(landed - tracked.registered_vertices, axis=1).mean() < 0.02


def test_every_vertex_is_in_the_correspondence(tracked, pose1, pose2):
    assert set(tracked.correspondence[:, 0]) == set(range(len(pose1.vertices)))
    assert set(tracked.correspondence[:, 1]) == set(range(len(pose2.vertices)))


def test_hypotheses_and_ambiguity(tracked):
    assert len(tracked.hypotheses) > 1 and tracked.levels == []
    energies = [hypothesis.coarse_energy for hypothesis in tracked.hypotheses]
    assert min(energies) > 0
    assert 0 <= tracked.ambiguity <= 1 and tracked.oriented and not tracked.mirrored
    assert tracked.energy > 0 and tracked.distance > 0
    assert tracked.seconds["refinement"] > 0


def test_a_right_map_has_a_good_fit(tracked):
    fit = tracked.fit
    assert fit.grade == "good" and fit.reasons == [] and tracked.warnings == []
    assert 0 < fit.stretch < 0.2 and fit.relief > 0.6
    assert 0 == fit.distorted == fit.unreached == fit.unmatched and fit.reversed < 0.045


def test_a_map_of_the_paper_is_judged_too(paper):
    assert paper.fit.grade in ("good", "doubtful", "poor")
    assert [f"{paper.fit.grade} fit: {reason}" for reason in paper.fit.reasons] == [
        text for text in paper.warnings if " fit: " in text]


def test_a_map_between_different_things_is_poor(tracked):
    ball = isomatch.synthesize(vertices=1000, seed=1)
    stretched = (ball.vertices * [1, 1, 6], ball.faces)
    with pytest.warns(isomatch.MatchWarning, match="fit: "):
        result = isomatch.match(ball, stretched)
    assert result.fit.grade == "poor" and result.fit.reasons


def test_a_landmark_that_contradicts_the_shapes_is_named(pose1, pose2, tracked):
    front = int(pose1.rest[:, 2].argmax())
    behind = int(pose2.rest[:, 2].argmin())
    with pytest.warns(isomatch.MatchWarning, match=f"landmark {front} {behind} contradicts"):
        result = isomatch.match(pose1, pose2, landmarks=[[front, behind]])
    assert result.contradicted_landmarks.tolist() == [[front, behind]]
    assert tracked.contradicted_landmarks.shape == (0, 2)


def test_levels_of_the_paper(paper):
    assert len(paper.levels) == 5 and paper.hypotheses == []
    for coarse, fine in zip(paper.levels, paper.levels[1:]):
        assert np.array_equal(fine.source_bases[: len(coarse.source_bases)], coarse.source_bases)
        assert fine.source_radius < coarse.source_radius
    for level in paper.levels:
        assert set(level.matches[:, 0]) == set(level.source_bases)
        assert set(level.matches[:, 1]) == set(level.target_bases)
        assert len(level.distortion) == len(level.matches)
        assert np.array_equal(np.sort(level.source_bases), level.many_to_one[:, 0])
    assert paper.registered_vertices is None and paper.ambiguity is None
    matched = paper.source_to_target >= 0
    assert set(np.flatnonzero(matched)) == set(paper.levels[-1].source_bases)
    assert np.all(paper.barycentric[matched].max(axis=1) == 1)
    assert np.all(paper.triangles[~matched] == -1)


def saved_files(folder):
    return {
        os.path.relpath(os.path.join(root, name), folder)
        for root, _, names in os.walk(folder)
        for name in names
    }


def assert_same_bytes(ours, theirs):
    assert saved_files(ours) == saved_files(theirs)
    for name in saved_files(ours) - {"report.json"}:
        assert (ours / name).read_bytes() == (theirs / name).read_bytes(), name
    reports = [json.loads((folder / "report.json").read_text()) for folder in (ours, theirs)]
    for report in reports:
        for varying in ("command", "seconds", "peak_memory_mib", "peak_memory_mib_after"):
            del report[varying]
    assert reports[0] == reports[1]


def test_tracked_saves_what_the_program_writes(files, program, tmp_path):
    pair = files / "source.off", files / "target.ply"
    best = isomatch.match(*pair, alternatives=2)
    best.save(tmp_path / "ours", target_to_source=True)
    program("match", *pair, "-o", tmp_path / "theirs", "--alternatives", 2, "--target-to-source")
    assert_same_bytes(tmp_path / "ours", tmp_path / "theirs")
    command = json.loads((tmp_path / "ours" / "report.json").read_text())["command"]
    program(*command[1:5], tmp_path / "again", *command[6:])
    assert_same_bytes(tmp_path / "ours", tmp_path / "again")


def test_paper_saves_what_the_program_writes(files, program, tmp_path):
    pair = files / "source.off", files / "target.ply"
    isomatch.match(*pair, method="paper", levels=3, full_share=0.8).save(tmp_path / "ours")
    program(
        "match", *pair, "-o", tmp_path / "theirs",
        "--method", "paper", "--levels", 3, "--full-share", 0.8,
    )
    assert_same_bytes(tmp_path / "ours", tmp_path / "theirs")


def test_arrays_are_saved_with_the_result(tracked, program, tmp_path, pose1):
    tracked.save(tmp_path / "out")
    vertices, _ = isomatch.read_mesh(tmp_path / "out" / "source.ply")
    assert np.array_equal(vertices, pose1.vertices)
    program("render", tmp_path / "out", "-o", tmp_path / "picture.png")
    assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG")


def test_landmarks_are_kept(pose1, pose2, tmp_path):
    pairs = np.column_stack([pose1.ground_truth[:3], pose2.ground_truth[:3]])
    result = isomatch.match(pose1, pose2, landmarks=pairs)
    result.save(tmp_path)
    assert np.array_equal(np.loadtxt(tmp_path / "landmarks.txt", dtype=int), pairs)
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["options"]["landmarks"] == str(tmp_path / "landmarks.txt")
    assert "--landmarks" in report["command"]
    vertices = pose2.vertices
    gaps = vertices[result.source_to_target[pairs[:, 0]]] - vertices[pairs[:, 1]]
    assert np.linalg.norm(gaps, axis=1).max() < 0.2


def test_a_shape_is_prepared_once_and_used_often(pose1, pose2, tracked):
    source = isomatch.Shape(pose1)
    assert isomatch.match(source, pose2).source is source
    again = isomatch.match(source, isomatch.Shape(pose2), threads=1)
    assert np.array_equal(again.source_to_target, tracked.source_to_target)
    assert np.array_equal(again.registered_vertices, tracked.registered_vertices)


def test_options_change_the_result(pose1, pose2, tracked):
    coarse = isomatch.match(pose1, pose2, refinement=False)
    assert "refinement" not in coarse.seconds or coarse.energy != tracked.energy
    assert len(isomatch.match(pose1, pose2, alternatives=1).alternatives) <= 1


class Manifest(HTMLParser):
    """Finds the frame that a notebook shows and, in it, the page's data."""

    page = None
    in_manifest = False
    data = ""

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "iframe":
            self.page = attributes["srcdoc"]
        self.in_manifest = attributes.get("id") == "isomatch-manifest"

    def handle_data(self, data):
        if self.in_manifest:
            self.data += data


@pytest.mark.skipif(not _core.has_page(), reason="built without the page of a report")
def test_a_notebook_shows_the_report(tracked):
    frame = Manifest()
    frame.feed(tracked._repr_html_())
    page = Manifest()
    page.feed(frame.page)
    assert json.loads(page.data)["maps"]


def test_without_the_page_a_notebook_shows_a_line(tracked, monkeypatch):
    monkeypatch.setattr(_core, "has_page", lambda: False)
    assert tracked._repr_html_().startswith("<pre>&lt;isomatch.Match by the tracked method")


@pytest.mark.parametrize(
    "keywords, error, message",
    [
        ({"method": "magic"}, ValueError, "method: expected 'tracked' or 'paper', not 'magic'"),
        ({"levels": 3}, TypeError, "no option 'levels': it is one of the paper's method"),
        ({"method": "paper", "levels": -1}, ValueError, "levels"),
        ({"method": "paper", "landmarks": [[0, 0]]}, ValueError, "landmarks"),
        ({"alternatives": -1}, ValueError, "alternatives"),
        ({"alternatives": "two"}, TypeError, "alternatives: expected int, not 'two'"),
        ({"landmarks": [[0, 10**6]]}, ValueError, "target vertex 1000000 is out of range"),
        ({"landmarks": [[0, 1], [0, 2]]}, ValueError, "source vertex 0 has two landmarks"),
        ({"landmarks": [0, 1]}, ValueError, r"landmarks: expected shape \(N, 2\)"),
        ({"geodesics": "air"}, ValueError, "geodesics: expected w20, w10 or edges"),
    ],
)
def test_bad_arguments(pose1, pose2, keywords, error, message):
    with pytest.raises(error, match=message):
        isomatch.match(pose1, pose2, **keywords)


def test_saving_replaces_nothing_of_the_users(files, tracked, tmp_path):
    for name in ("source.ply", "registered.ply", "report.json"):
        (tmp_path / name).write_text("the user's")
        with pytest.raises(OSError, match=f"{name}: isomatch did not write"):
            tracked.save(tmp_path)
        assert os.listdir(tmp_path) == [name]
        assert (tmp_path / name).read_text() == "the user's"
        (tmp_path / name).unlink()
    (tmp_path / "notes.txt").write_text("the user's")
    for _ in range(2):
        tracked.save(tmp_path)
    assert (tmp_path / "notes.txt").read_text() == "the user's"
    # What was saved may be what is read.
    given = isomatch.match(tmp_path / "registered.ply", tmp_path / "target.ply", refinement=False)
    before = (tmp_path / "registered.ply").read_bytes()
    with pytest.raises(OSError, match="is read here"):
        given.save(tmp_path)
    assert (tmp_path / "registered.ply").read_bytes() == before


def test_paths_that_are_not_utf8(tmp_path, pose1, pose2, program):
    folder = os.path.join(os.fsencode(tmp_path), b"\xfcber")
    os.mkdir(folder)
    mesh, output = (os.fsdecode(os.path.join(folder, name)) for name in (b"K\xf6rper.off", b"\xe4us"))
    isomatch.write_mesh(mesh, pose1)
    assert np.array_equal(isomatch.read_mesh(mesh)[0], pose1.vertices)
    result = isomatch.match(mesh, pose2, refinement=False)
    assert result.source.path == mesh
    result.save(output)
    report = json.loads((Path(output) / "report.json").read_text())
    assert report["source"]["file_escaped"].endswith("/%FCber/K%F6rper.off")
    program("render", output, "-o", tmp_path / "picture.png")
    with pytest.raises(OSError, match="off"):
        isomatch.read_mesh(os.fsdecode(os.path.join(folder, b"\xe4.off")))


def test_bad_folders_are_os_errors(tracked, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError):
        tracked.save(tmp_path / "file")
