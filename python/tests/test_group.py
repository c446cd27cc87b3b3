# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
import json
import pickle

import numpy as np
import pytest
from test_batch import QUICK, lump
from test_match import Manifest, assert_same_bytes

import isomatch
from isomatch import _core

NAMES = ["sitting", "running", "lying", "jumping", "standing"]


@pytest.fixture(scope="module")
def creatures():
    return [isomatch.synthesize(vertices=1000, pose=pose, seed=2) for pose in range(1, 6)]


@pytest.fixture(scope="module")
def group(creatures):
    return isomatch.group(creatures, names=NAMES)


@pytest.fixture(scope="module")
def lumps():
    return [(vertices, np.array(faces)) for vertices, faces in (lump(k, 10, 12) for k in range(3))]


@pytest.fixture(scope="module")
def three_files(lumps, tmp_path_factory):
    folder = tmp_path_factory.mktemp("lumps")
    files = [folder / f"{name}.off" for name in NAMES[:3]]
    for file, shape in zip(files, lumps):
        isomatch.write_mesh(file, shape)
    return files


@pytest.fixture(scope="module")
def coarse(three_files):
    """Quickly matched, with few points."""
    return isomatch.group(three_files, points=30, template="lying", keep_size=True, **QUICK)


@pytest.fixture(scope="module")
def with_a_part(creatures):
    shapes = creatures[:2] + [isomatch.synthesize(vertices=1000, pose=4, seed=2, cut=0.3)]
    return shapes, isomatch.group(shapes, template=0, refinement=False)


def root_area(shape):
    return np.sqrt(isomatch.Shape(shape).area)


def error_of(result, source, target):
    truth = (source.ground_truth, target.ground_truth)
    figures = isomatch.evaluate(source, target, result, truth)["ground_truth"]
    return figures["point_error_over_sqrt_area"]["mean"]


def landed(result, shape):
    """Where each source vertex lands, NaN where it is unmatched."""
    points = np.einsum(
        "nk,nkd->nd", result.barycentric, shape.vertices[shape.faces[result.triangles]]
    )
    points[result.triangles < 0] = np.nan
    return points


def test_all_have_the_same_points(group, creatures):
    points = len(creatures[group.template].vertices)
    assert group.names == NAMES and len(group) == 5
    assert np.array_equal(group.template_vertices, np.arange(points))
    assert np.array_equal(group.template_faces, creatures[group.template].faces)
    assert group.points.shape == group.registered_points.shape == (5, points, 3)
    assert group.present.shape == group.spread.shape == (5, points)
    assert group.present.all() and np.isfinite(group.points).all()
    assert np.allclose(group.points[group.template], creatures[group.template].vertices)
    assert group.grades == ["good"] * 5 and group.fits[0].stretch < 0.2
    assert np.nanmax(group.spread.mean(axis=1)) < 0.1
    assert group.warnings == [] and group.seconds


def off_surface(points, nearest, shape):
    """Mean distance of registered points from the surface."""
    return np.linalg.norm(points - nearest, axis=1).mean() / root_area(shape)


def test_every_map_is_right(group, creatures):
    for a, source in enumerate(creatures):
        for b, target in enumerate(creatures):
            # An edge is .04.
            assert a == b or error_of(group.map(a, b), source, target) < 0.04


def test_maps_around_a_cycle_lead_back(group, creatures):
    """Through the template, so that what remains is the rounding at vertices."""
    start = creatures[0]
    there, on, back = (group.map(a, b) for a, b in ((0, 1), (1, 2), (2, 0)))
    first = landed(there, creatures[1])
    assert np.isfinite(first).all()
    around = back.source_to_target[on.source_to_target[there.source_to_target]]
    gaps = np.linalg.norm(start.vertices[around] - start.vertices, axis=1)
    assert gaps.mean() / root_area(start) < 0.03


def test_maps_of_the_template_are_those_of_the_points(group, creatures):
    for name, points, shape in zip(NAMES, group.points, creatures):
        out = group.from_template(name)
        assert off_surface(points, landed(out, shape), shape) < 0.003
        assert out.fit == group.fits[NAMES.index(name)]
        back = group.to_template(name)
        assert np.array_equal(back.source_to_target, out.target_to_source)
        assert back.source is out.target is group.shapes[NAMES.index(name)]


def test_a_map_carries_over(group, creatures):
    carried = group.map("sitting", "lying").transfer(creatures[0].rest[:, 1])
    assert np.abs(carried - creatures[2].rest[:, 1]).mean() < 0.05


def test_pairs_are_told(group):
    assert {pair.use for pair in group.pairs} <= {"agrees", "runner-up", "composed"}
    star = [pair for pair in group.pairs if group.template in (pair.source, pair.target)]
    assert len(star) >= 4 and all(pair.cost > 0 for pair in group.pairs)
    assert group.cycle_errors.shape == (5,) and group.cycle_errors.max() < 0.1


def test_neither_names_nor_forms_of_shapes_change_anything(coarse, lumps):
    seen = []
    ready = isomatch.Shape(lumps[1])
    other = isomatch.group(
        [isomatch.Shape(lumps[0]), ready, lumps[2]],
        points=30,
        template=2,
        threads=1,
        progress=lambda fraction, stage: seen.append(fraction),
        **QUICK,
    )
    assert other.names == ["shape0", "shape1", "shape2"] and other.shapes[1] is ready
    assert coarse.names == NAMES[:3] and other.template == coarse.template == 2
    assert np.array_equal(other.points, coarse.points) and other.pairs == coarse.pairs
    assert seen == sorted(seen) and len(seen) > 5


def test_what_a_part_lacks_is_not_there(with_a_part):
    shapes, group = with_a_part
    whole, part = shapes[0], shapes[2]
    assert group.present[:2].all()
    # Entry i of both truths is the same place, -1 where it was cut off.
    pairs = np.column_stack([whole.ground_truth, part.ground_truth])
    kept = np.unique(pairs[pairs[:, 1] >= 0, 0])
    lost = np.setdiff1d(pairs[pairs[:, 1] < 0, 0], kept)
    assert group.present[2, kept].mean() > 0.9 and group.present[2, lost].mean() < 0.2
    missing = ~group.present[2]
    assert np.isnan(group.points[2, missing]).all() and np.isnan(group.spread[2, missing]).all()
    assert np.isfinite(group.registered_points).all()
    model = group.model()
    assert np.isfinite(model.completed).all() and np.isfinite(model.mean).all()
    assert np.allclose(model.completed[group.present], group.points[group.present])
    assert np.any(group.map(0, 2).source_to_target < 0)


def test_a_shape_that_none_matches_has_no_points_and_is_not_saved(creatures, tmp_path):
    corners = 0.01 * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    crumb = corners, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    with pytest.warns(isomatch.MatchWarning, match="crumb: poor fit"):
        group = isomatch.group(
            [*creatures[:2], crumb], names=["a", "b", "crumb"], refinement=False, scale="same"
        )
    group = pickle.loads(pickle.dumps(group))
    assert group.present.all(axis=1).tolist() == [True, True, False]
    assert not group.present[2].any() and np.isnan(group.registered_points[2]).all()
    assert group.grades[2] == group.map(0, 2).fit.grade == "poor"
    assert np.all(group.map("crumb", "a").source_to_target == -1)
    with pytest.raises(ValueError, match="shape 2 has fewer than three points"):
        group.model()
    group.save(tmp_path)
    assert np.load(tmp_path / "points.npz")["names"].tolist() == ["a", "b"]


def test_the_model_is_that_of_the_points(group):
    model = group.model()
    points = len(group.template_vertices)
    assert model.mean.shape == group.mean.shape == (points, 3)
    assert model.modes.shape == (4, points, 3) and model.scores.shape == (5, 4)
    assert model.variances.shape == (4,) and np.all(np.diff(model.variances) <= 0)
    assert np.allclose(np.einsum("kpd,lpd->kl", model.modes, model.modes), np.eye(4))
    rebuilt = model.mean + np.tensordot(model.scores, model.modes, 1)
    assert np.allclose(rebuilt, model.aligned)
    assert np.allclose(model.scores.var(axis=0, ddof=1), model.variances)
    assert model.compactness[-1] == pytest.approx(1)
    for figures in (model.generalisation, model.specificity):
        assert figures.shape == (4,) and np.all(figures > 0)
    deviations = model.scores[1] / np.sqrt(model.variances)
    assert np.allclose(model.shape_at(deviations), model.aligned[1])
    placed = group.points @ model.alignments[:, :3, :3].transpose(0, 2, 1)
    assert np.allclose(placed + model.alignments[:, None, :3, 3], model.aligned)
    assert group.model(modes=2).scores.shape == (5, 2)


def test_a_model_of_own_points():
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1.0]])
    tall = square * [1, 1, 2]
    shapes = np.stack([square, tall + 7, tall @ [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], 3 * square])
    model = isomatch.shape_model(shapes)
    assert len(model.variances) == 1                # height over width, all else is undone
    sizes = isomatch.shape_model(shapes, keep_size=True)
    assert sizes.variances[0] > model.variances[0]
    assert np.linalg.det(sizes.alignments[3, :3, :3]) == pytest.approx(1)
    gap = shapes.copy()
    gap[3, 4] = np.nan
    present = np.isfinite(gap).all(axis=2)
    by_nan, by_mask = isomatch.shape_model(gap), isomatch.shape_model(shapes, present)
    assert np.array_equal(by_nan.mean, by_mask.mean)
    assert np.isfinite(by_nan.completed).all()


def test_evenly_spread_points(coarse, lumps):
    shape = isomatch.Shape(lumps[0])
    assert coarse.points.shape == (3, 30, 3)
    everywhere = landed(coarse.from_template(0), shape)
    on_surface = everywhere[coarse.template_vertices]
    assert off_surface(coarse.points[0], on_surface, shape) < 0.003
    gaps = np.linalg.norm(coarse.points[2][:, None] - coarse.points[2], axis=2)
    assert gaps[gaps > 0].min() > 0.1 * root_area(lumps[2])


def test_a_group_is_kept_whole(group):
    copy = pickle.loads(pickle.dumps(group))
    assert copy.names == group.names and copy.pairs == group.pairs and copy.fits == group.fits
    assert copy.seconds == group.seconds and copy.template == group.template
    for name in ("points", "present", "spread", "registered_points", "template_faces"):
        assert np.array_equal(getattr(copy, name), getattr(group, name)), name
    assert np.array_equal(copy.map(0, 1).barycentric, group.map(0, 1).barycentric)


def test_saves_what_the_program_writes(coarse, three_files, program, tmp_path):
    report = ["--report"] if _core.has_page() else []
    for _ in range(2):
        coarse.save(tmp_path / "ours", all_maps=True, report=bool(report))
    program("group", *three_files, "-o", tmp_path / "theirs", "--template", "lying",
            "--keep-size", "--points", 30, "--no-refinement", "--no-elastic-judging", "--all-maps",
            *report)
    command = json.loads((tmp_path / "ours" / "report.json").read_text())["command"]
    place = command.index("-o") + 1
    program(*command[1:place], tmp_path / "again", *command[place + 1:])
    for folder in (tmp_path / "ours", tmp_path / "theirs", tmp_path / "again"):
        if report:          # It tells the command line.
            assert (folder / "group.html").stat().st_size > 10**5
            (folder / "group.html").write_text("")
        assert_same_bytes(tmp_path / "ours", folder)


def test_arrays_are_saved_with_the_group(group, creatures, tmp_path):
    (tmp_path / "notes.txt").write_text("the user's")
    for _ in range(2):
        group.save(tmp_path, modes=2)
    vertices, faces = isomatch.read_mesh(tmp_path / "shapes" / "running.ply")
    assert np.array_equal(vertices, creatures[1].vertices)
    saved = np.load(tmp_path / "points.npz")
    assert np.array_equal(saved["points"], group.points)
    assert saved["names"].tolist() == NAMES
    assert np.load(tmp_path / "modes.npz")["variances"].shape == (2,)
    read = isomatch.read_map(tmp_path / "maps" / "running.from_template.bary.txt")
    assert np.array_equal(read.triangles, group.from_template("running").triangles)
    (tmp_path / "report.json").unlink()
    with pytest.raises(OSError, match="isomatch did not write"):
        group.save(tmp_path)
    assert (tmp_path / "notes.txt").read_text() == "the user's"


@pytest.mark.skipif(not _core.has_page(), reason="built without the page of a report")
def test_a_notebook_shows_the_collection(group, tmp_path):
    frame = Manifest()
    frame.feed(group._repr_html_())
    page = Manifest()
    page.feed(frame.page)
    assert [member["name"] for member in json.loads(page.data)["members"]] == NAMES
    group.report(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text().startswith("<!")
    with pytest.raises(OSError, match="html"):
        group.report(tmp_path / "page.txt")


def test_without_the_page_a_notebook_shows_a_line(group, monkeypatch):
    monkeypatch.setattr(_core, "has_page", lambda: False)
    assert group._repr_html_().startswith("<pre>&lt;isomatch.Group of 5 shapes with ")


def test_what_the_callback_raises_ends_the_work(creatures):
    def stop(fraction, stage):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        isomatch.group(creatures, progress=stop)


@pytest.mark.parametrize(
    "keywords, error, message",
    [
        ({"names": ["a", "a", "b", "c", "d"]}, ValueError, "two shapes have the name 'a'"),
        ({"names": ["a"]}, ValueError, "names: 1 for 5 shapes"),
        ({"names": ["a/b", "a", "b", "c", "d"]}, ValueError, "'a/b' cannot be the name"),
        ({"template": "cat"}, ValueError, "no shape has the name 'cat'"),
        ({"template": 5}, ValueError, "there is no shape 5: they are numbered from 0 to 4"),
        ({"neighbours": -1}, ValueError, "neighbours: expected 0 or more"),
        ({"points": -5}, ValueError, "points: expected 0 or more"),
        ({"memory": -1.0}, ValueError, "memory: expected 0 or more"),
        ({"memory": "much"}, TypeError, "memory: expected GiB"),
        ({"levels": 3}, TypeError, "group has no option 'levels'"),
        ({"alternatives": -1}, ValueError, "alternatives"),
    ],
)
def test_bad_arguments(creatures, keywords, error, message):
    with pytest.raises(error, match=message):
        isomatch.group(creatures, **keywords)


def test_bad_shapes(creatures, tmp_path):
    with pytest.raises(ValueError, match="a group needs at least two shapes"):
        isomatch.group(creatures[:1])
    with pytest.raises(TypeError, match="expected a list of meshes"):
        isomatch.group("creatures")
    with pytest.raises(OSError, match="gone.off"):
        isomatch.group([creatures[0], tmp_path / "gone.off"])
    with pytest.raises(ValueError, match="^shape1: "):
        isomatch.group([creatures[0], (np.zeros((3, 3)), np.zeros((0, 3), int))])


def test_bad_points(group):
    with pytest.raises(ValueError, match=r"points: expected shape \(N, P, 3\), not \(4, 3\)"):
        isomatch.shape_model(np.zeros((4, 3)))
    with pytest.raises(ValueError, match=r"present: expected shape \(5, "):
        isomatch.shape_model(group.points, group.present[:3])
    with pytest.raises(ValueError, match="finite"):
        isomatch.shape_model(np.full((3, 4, 3), np.inf))
    with pytest.raises(ValueError, match="modes: expected 0 or more"):
        group.model(modes=-2)
    with pytest.raises(ValueError, match="deviations"):
        group.model(modes=1).shape_at([1, 2])
    with pytest.raises(ValueError, match="no shape has the name 'x'"):
        group.map("x", 0)
