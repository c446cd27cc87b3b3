# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Forms in which people give things, hints where they are others, and warnings."""
import inspect
import re
import sys
import types
import warnings

import numpy as np
import pytest

import isomatch


class PyFM:
    def __init__(self, vertices, faces):
        self.vertlist, self.facelist = vertices, faces


@pytest.mark.parametrize(
    "form",
    [
        list,
        lambda sheet: {"vertices": sheet[0], "faces": sheet[1]},
        lambda sheet: PyFM(*sheet),
        lambda sheet: (sheet[0], sheet[1].astype(float)),
        lambda sheet: (sheet[0].tolist(), sheet[1].tolist()),
    ],
)
def test_meshes_have_many_forms(sheet, form):
    shape = isomatch.Shape(form(sheet))
    assert np.array_equal(shape.vertices, sheet[0]) and np.array_equal(shape.faces, sheet[1])


def test_vertices_and_faces_as_arguments_are_a_hint(sheet):
    with pytest.raises(TypeError, match=r"as in match\(\(vertices, faces\), \(vertices, faces\)\)"):
        isomatch.match(*sheet, *sheet)
    with pytest.raises(TypeError, match="not ndarray; give both arrays as one"):
        isomatch.Shape(sheet[0])


def test_truths_may_be_lists(tracked, pose1, pose2, files):
    truth = pose1.ground_truth, pose2.ground_truth
    figures = tracked.evaluate(truth)
    assert tracked.evaluate(list(truth)) == figures
    assert tracked.evaluate([part.tolist() for part in truth]) == figures
    assert tracked.evaluate([files / "source.vts", str(files / "target.vts")]) == figures
    assert tracked.evaluate(np.column_stack(truth)) == figures


def test_two_pairs_are_pairs(sheet):
    identity = np.arange(441)
    figures = isomatch.evaluate(sheet, sheet, identity, [[7, 7], [30, 30]])
    assert figures["ground_truth"]["error_over_sqrt_area"]["maximum"] == 0


def test_landmarks_may_be_a_file(files, program, tmp_path, pose1, pose2):
    pair = files / "source.off", files / "target.ply"
    pairs = np.column_stack([pose1.ground_truth[:3], pose2.ground_truth[:3]])
    np.savetxt(tmp_path / "landmarks.txt", pairs, fmt="%d")
    result = isomatch.match(*pair, landmarks=tmp_path / "landmarks.txt", refinement=False)
    result.save(tmp_path / "ours")
    program("match", *pair, "-o", tmp_path / "theirs", "--no-refinement",
            "--landmarks", tmp_path / "landmarks.txt")
    assert not (tmp_path / "ours" / "landmarks.txt").exists()
    for name in ("source_to_target.bary.txt", "registered.ply"):
        assert (tmp_path / "ours" / name).read_bytes() == (tmp_path / "theirs" / name).read_bytes()
    with pytest.raises(OSError, match="absent.txt"):
        isomatch.match(*pair, landmarks=tmp_path / "absent.txt")


@pytest.mark.parametrize(
    "call, error, hint",
    [
        (lambda m: isomatch.match(m, m, landmarks=[[1, 2, 3], [4, 5, 6]]), ValueError, "transp"),
        (lambda m: isomatch.map_orientation(m, m, [[1, 2, 3], [4, 5, 6]]), ValueError, "transp"),
        (lambda m: isomatch.match(m, m, levels=3), TypeError,
         r"match\(method='tracked'\) has no option 'levels': it is one of the paper's method"),
        (lambda m: isomatch.match(m, m, "paper", max_levels=3), TypeError, "did you mean 'levels'"),
        (lambda m: isomatch.match(m, m, alternative=3), TypeError, "did you mean 'alternatives'"),
        (lambda m: isomatch.match(m, m, progress=3), TypeError, "expected True or a function"),
        (lambda m: isomatch.match(m, m, "paper", levels=2.5), TypeError, "levels: expected int"),
    ],
)
def test_mistakes_get_hints(sheet, call, error, hint):
    with pytest.raises(error, match=hint):
        call(sheet)


def test_help_groups_options():
    text = isomatch.match.__doc__
    tracked = text.index("Options of the tracked method")
    paper = text.index("Options of the paper's method")
    assert tracked < text.index("\n    alternatives = 0") < paper < text.index("\n    levels = 100")


def test_methods_are_literals():
    annotation = inspect.signature(isomatch.match).parameters["method"].annotation
    assert annotation == "Method"
    from isomatch import _types

    assert _types.Method.__args__ == ("tracked", "paper")


def test_defects_and_doubts_are_warned_of(sheet):
    with pytest.warns(isomatch.MatchWarning) as caught:
        result = isomatch.match(sheet, sheet, refinement=False)
    assert {str(warning.message) for warning in caught} <= set(result.warnings)
    assert any("ambiguous" in text for text in result.warnings)
    assert all(warning.filename == __file__ for warning in caught)


def test_a_good_match_does_not_warn(pose1, pose2):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert isomatch.match(pose1, pose2).warnings == []


def test_what_files_lack_is_warned_of(tmp_path, pose1):
    isomatch.write_mesh(tmp_path / "a.obj", pose1)
    with open(tmp_path / "a.obj", "a") as file:
        file.write("f 1 2\n")
    with pytest.warns(isomatch.MatchWarning, match="^source: .*face"):
        isomatch.match(tmp_path / "a.obj", pose1, refinement=False)


@pytest.mark.parametrize(
    "values, warns",
    [
        (np.repeat([1.0, 2, 3], 147), "look like labels"),
        (np.arange(441), "nearly all differ"),
        (np.repeat([1, 2, 3], 147), None),
        (np.linspace(0, 1, 441), None),
        (np.ones(441), None),
        (np.repeat([True, False], [400, 41]), None),
    ],
)
def test_types_that_look_wrong_are_warned_of(sheet, values, warns):
    transfer = isomatch.Transfer(sheet, sheet, np.arange(441))
    if warns:
        with pytest.warns(isomatch.MatchWarning, match=warns):
            transfer(values)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        transfer.values(values)
        if not warns:
            transfer(values)


def test_a_transfer_of_nothing_is_warned_of(sheet):
    nothing = isomatch.Transfer(sheet, sheet, np.full(441, -1))
    for carry in (nothing.values, nothing.labels):
        with pytest.warns(isomatch.MatchWarning, match="no target vertex is matched"):
            carry(np.zeros(441, int))


def test_everything_has_a_short_name(tracked, paper, pose1, tmp_path):
    things = [
        tracked, paper, tracked.transfer, pose1, paper.levels[0], tracked.distortion(),
        tracked.transfer.landmarks([1, 2]), tracked.source, isomatch.error_curve([0, 1]),
        isomatch.Map((tracked.source, tracked.target), {
            "vertices": tracked.source_to_target, "triangles": 0, "barycentric": 0
        }, tracked.fit._asdict()),
    ]
    for thing in things:
        name = type(thing).__name__
        assert re.fullmatch(rf"<isomatch\.{name}\b[^\n]{{10,120}}>", repr(thing)), repr(thing)


def test_errors_of_vertices(tracked, pose1, pose2):
    truth = pose1.ground_truth, pose2.ground_truth, pose2.symmetric_ground_truth
    figures = tracked.evaluate(truth, per_vertex=True)
    errors = figures["ground_truth"].pop("per_vertex")
    curve = figures["ground_truth"].pop("curve")
    flipped = figures["symmetric_ground_truth"].pop("per_vertex")
    figures["symmetric_ground_truth"].pop("curve")
    assert figures == tracked.evaluate(truth)
    assert errors.shape == (len(pose1.vertices),)
    assert np.array_equal(np.isnan(errors), ~np.isin(np.arange(len(errors)), truth[0]))
    statistics = figures["ground_truth"]["point_error_over_sqrt_area"]
    assert np.nanmax(errors) <= statistics["maximum"] * (1 + 1e-9)
    # A vertex counts as often as template points lie on it.
    assert errors[truth[0]].mean() == pytest.approx(statistics["mean"], rel=0.2)
    assert np.nanmean(flipped) > np.nanmean(errors)
    assert curve.thresholds[0] == 0 and curve.thresholds[-1] == 0.25 and len(curve.shares) == 100
    assert np.all(np.diff(curve.shares) >= 0) and 0.9 < curve.shares[-1] <= 1


def test_errors_are_those_of_their_vertices(sheet):
    identity = np.arange(441)
    wrong = identity.copy()
    wrong[7], wrong[8] = 27, -1
    known = identity[identity != 9]
    figures = isomatch.evaluate(sheet, sheet, wrong, (known, known), per_vertex=True)
    errors = figures["ground_truth"]["per_vertex"]
    assert errors[7] == pytest.approx(isomatch.geodesic_distances(sheet, 7)[27], rel=1e-6)
    assert np.isnan(errors[[8, 9]]).all() and np.count_nonzero(errors == 0) == 438
    pairs = np.array([[7, 7], [7, 27]])
    both = isomatch.evaluate(sheet, sheet, pairs, identity, per_vertex=True)
    assert both["ground_truth"]["per_vertex"][7] == pytest.approx(errors[7] / 2)
    assert "ground_truth" not in isomatch.evaluate(sheet, sheet, wrong, per_vertex=True)


def test_vertices_off_the_surface_have_no_error(sheet):
    more = np.vstack([sheet[0], [[5, 5, 5]]]), sheet[1]
    identity = np.arange(442)
    figures = isomatch.evaluate(more, more, identity, identity, per_vertex=True)
    errors = figures["ground_truth"]["per_vertex"]
    assert errors.shape == (442,) and np.flatnonzero(np.isnan(errors)).tolist() == [441]


def test_error_curves_count():
    curve = isomatch.error_curve([0, 0.1, np.nan, 0.2, 1], maximum=0.2, points=3)
    assert curve.thresholds.tolist() == [0, 0.1, 0.2]
    assert curve.shares.tolist() == [0.25, 0.5, 0.75]
    assert np.isnan(isomatch.error_curve([np.nan]).shares).all()


def test_progress_is_a_line_without_tqdm(pose1, pose2, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    isomatch.match(pose1, pose2, refinement=False, progress=True)
    output = capsys.readouterr()
    assert output.out == "" and output.err.rstrip().endswith("100 % done")
    assert re.search(r"\r *\d+ % hypotheses", output.err) and output.err.count("\n") == 1


def test_progress_is_a_bar_with_tqdm(pose1, pose2, monkeypatch):
    bars = []

    class Bar:
        def __init__(self, total, **_):
            self.n, self.total, self.closed, self.stages = 0, total, False, []
            bars.append(self)

        def set_description(self, stage):
            self.stages.append(stage)

        def update(self, by):
            self.n += by

        def close(self):
            self.closed = True

    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", types.SimpleNamespace(tqdm=Bar))
    isomatch.match(pose1, pose2, refinement=False, progress=True)
    assert bars[0].closed and bars[0].n == pytest.approx(bars[0].total)
    assert "hypotheses" in bars[0].stages


def test_progress_may_be_off(pose1, capsys):
    isomatch.geodesic_diameter(pose1, progress=False)
    assert capsys.readouterr().err == ""
