# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Results are kept: by pickle, as copies, by other processes, in folders."""
import copy
import json
import multiprocessing
import os
import pickle
import shutil

import numpy as np
import pytest

import isomatch


def again(value):
    return pickle.loads(pickle.dumps(value))


def assert_equal(a, b):
    """Equal to the last byte, arrays and all that they are in."""
    assert type(a) is type(b)
    if isinstance(a, np.ndarray):
        assert a.dtype == b.dtype and np.array_equal(a, b, equal_nan=a.dtype.kind == "f")
    elif isinstance(a, (list, tuple)):
        assert len(a) == len(b)
        for one, other in zip(a, b):
            assert_equal(one, other)
    elif isinstance(a, isomatch.Shape):
        assert_equal(vars_of(a, SHAPE), vars_of(b, SHAPE))
    elif isinstance(a, isomatch.Map):
        assert_equal(vars_of(a, MAP), vars_of(b, MAP))
    else:
        assert a == b


SHAPE = "vertices faces path geodesics on_surface area warnings".split()
MAP = (
    "source target source_to_target triangles barycentric target_to_source registered_vertices "
    "energy distance mirrored confidence"
).split()
MATCH = "method ambiguity oriented taken_for seconds correspondence levels hypotheses warnings".split()


def vars_of(value, names):
    return [getattr(value, name) for name in names]


def assert_same_match(a, b):
    assert_equal(a, b)
    assert_equal(vars_of(a, MATCH), vars_of(b, MATCH))
    assert_equal(a.alternatives, b.alternatives)


@pytest.fixture(scope="module", params=["tracked", "paper"])
def given(request, files):
    """A match of files by each method, with all that it can have."""
    options = {"tracked": {"alternatives": 1}, "paper": {"levels": 3}}[request.param]
    return isomatch.match(
        files / "source.off", files / "target.ply", method=request.param, **options
    )


@pytest.mark.parametrize("kept", [again, copy.deepcopy, copy.copy])
def test_matches_come_back(given, kept, tmp_path):
    back = kept(given)
    assert_same_match(back, given)
    for name, result in (("a", given), ("b", back)):
        result.save(tmp_path / name)
    for name in ("source_to_target.txt", "correspondence.txt"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


def test_matches_of_arrays_and_landmarks_come_back(pose1, pose2, tmp_path):
    pairs = np.column_stack([pose1.ground_truth[:3], pose2.ground_truth[:3]])
    back = again(isomatch.match(pose1, pose2, landmarks=pairs.astype(float), refinement=False))
    assert back.source.path is None
    back.save(tmp_path)
    assert np.array_equal(np.loadtxt(tmp_path / "landmarks.txt", dtype=int), pairs)


@pytest.mark.parametrize("kept", [again, copy.deepcopy])
def test_parts_come_back(tracked, paper, pose1, kept):
    shape = isomatch.Shape(pose1, "w10")
    assert_equal(kept(shape), shape)
    assert kept(shape).max_geodesic == shape.max_geodesic
    assert_equal(kept(isomatch.Map((shape, shape), {
        "vertices": np.arange(3), "triangles": np.arange(3), "barycentric": np.eye(3)
    }, tracked.fit._asdict())).source_to_target, np.arange(3))
    assert_equal(kept(paper.levels[1]), paper.levels[1])
    assert kept(tracked.hypotheses) == tracked.hypotheses
    assert_equal(list(vars(kept(pose1)).values()), list(vars(pose1).values()))
    values = pose1.vertices
    assert_equal(kept(tracked.transfer)(values), tracked.transfer(values))
    assert_equal(kept(tracked.transfer.reverse).matched, tracked.transfer.reverse.matched)


def test_what_files_said_comes_back(tmp_path):
    (tmp_path / "a.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\nf 1 2\n"
    )
    shape = isomatch.Shape(tmp_path / "a.obj")
    assert shape.warnings and again(shape).warnings == shape.warnings
    (tmp_path / "a.obj").unlink()
    assert again(shape).path == shape.path


def test_a_pickle_of_other_meshes_is_refused(tracked, sheet):
    method, _, target, landmarks, state = tracked.__getstate__()
    broken = isomatch.Match.__new__(isomatch.Match)
    with pytest.raises(ValueError, match="does not fit its meshes"):
        broken.__setstate__((method, isomatch.Shape(sheet), target, landmarks, state))


def matched(meshes):
    return isomatch.match(*meshes, refinement=False, threads=1)


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_pools_take_shapes_and_give_matches(pose1, pose2, start):
    pair = isomatch.Shape(pose1), isomatch.Shape(pose2)
    here = matched(pair)
    with multiprocessing.get_context(start).Pool(2) as pool:
        there = pool.map_async(matched, [pair, pair]).get(timeout=120)
    for result in there:
        assert np.array_equal(result.source_to_target, here.source_to_target)
        assert np.array_equal(result.registered_vertices, here.registered_vertices)


VARYING = (
    "command seconds peak_memory_mib peak_memory_mib_after distortion many_to_one_distortion"
).split()


def assert_loaded(back, given):
    assert_equal(back, given)
    assert_equal(vars_of(back, ["method", "ambiguity", "oriented", "hypotheses"]),
                 vars_of(given, ["method", "ambiguity", "oriented", "hypotheses"]))
    assert_equal(back.correspondence, given.correspondence)
    assert_equal(back.alternatives, given.alternatives)
    assert back.seconds.items() >= given.seconds.items()
    assert back.warnings == given.warnings
    assert len(back.levels) == len(given.levels)
    for ours, theirs in zip(back.levels, given.levels):
        for name in ("source_bases", "target_bases"):
            assert_equal(np.sort(getattr(ours, name)), np.sort(getattr(theirs, name)))
        assert_equal(ours._replace(source_bases=0, target_bases=0),
                     theirs._replace(source_bases=0, target_bases=0))


def test_folders_are_loaded(given, tmp_path):
    given.save(tmp_path, target_to_source=given.method == "tracked")
    back = isomatch.load(tmp_path)
    assert_loaded(back, given)
    assert_same_match(again(back), back)
    # And saved like what was matched, but for the rounding of sums over bases.
    back.save(tmp_path / "again", target_to_source=given.method == "tracked")
    for name in os.listdir(tmp_path):
        one, other = tmp_path / name, tmp_path / "again" / name
        if one.is_file() and name not in ("report.json", "levels.json"):
            assert one.read_bytes() == other.read_bytes(), name
    reports = [json.loads((folder / "report.json").read_text())
               for folder in (tmp_path, tmp_path / "again")]
    for report in reports:
        for varying in VARYING:
            report.pop(varying, None)
    assert reports[0] == reports[1]


@pytest.mark.skipif(not isomatch._core.has_page(), reason="built without the page of a report")
def test_a_saved_page_is_that_of_its_folder(given, pose1, pose2, program, tmp_path):
    for match in given, isomatch.match(pose1, pose2, method=given.method):
        match.save(tmp_path, report=True)
        page = (tmp_path / "report.html").read_bytes()
        report = (tmp_path / "report.json").read_bytes()
        program("report", tmp_path)
        assert (tmp_path / "report.html").read_bytes() == page
        assert (tmp_path / "report.json").read_bytes() == report


@pytest.mark.parametrize("flags", [["--alternatives", 1], ["--method", "paper", "--levels", 2]])
def test_folders_of_the_program_are_loaded(files, program, tmp_path, flags):
    pair = files / "source.off", files / "target.ply"
    program("match", *pair, "-o", tmp_path, *flags)
    back = isomatch.load(tmp_path)
    assert np.array_equal(np.loadtxt(tmp_path / "source_to_target.txt", dtype=int),
                          back.source_to_target)
    assert back.target_to_source is None and back.source.path == str(pair[0])
    relation = np.loadtxt(tmp_path / "correspondence.txt", dtype=float)[:, :2]
    assert np.array_equal(back.correspondence, relation)
    assert back.seconds["reading"] > 0 and "writing" not in back.seconds
    assert np.array_equal(back.transfer.matched, isomatch.invert_map(
        back.source, back.target, back).triangles >= 0)
    with pytest.raises(ValueError, match="target_to_source"):
        back.save(tmp_path / "other", target_to_source=True)


def test_a_folder_that_was_moved_is_loaded(tracked, pose1, tmp_path):
    pairs = [[int(pose1.ground_truth[0]), int(tracked.source_to_target[pose1.ground_truth[0]])]]
    isomatch.match(tracked.source, tracked.target, landmarks=pairs, refinement=False).save(
        tmp_path / "first", target_to_source=True
    )
    shutil.move(tmp_path / "first", tmp_path / "second")
    back = isomatch.load(tmp_path / "second")
    assert np.array_equal(back.source.vertices, pose1.vertices)
    back.save(tmp_path / "third")
    assert np.array_equal(np.loadtxt(tmp_path / "third" / "landmarks.txt", ndmin=2), pairs)


def test_meshes_that_were_moved_are_told(files, tmp_path, given):
    mesh = tmp_path / "source.off"
    shutil.copy(files / "source.off", mesh)
    isomatch.match(mesh, files / "target.ply", refinement=False).save(tmp_path / "out")
    mesh.rename(tmp_path / "moved.off")
    with pytest.raises(OSError, match="source.off: is not there any more"):
        isomatch.load(tmp_path / "out")
    assert isomatch.load(tmp_path / "out", tmp_path / "moved.off").source.path.endswith("moved.off")
    with pytest.raises(OSError, match="target.ply"):
        isomatch.load(tmp_path / "out", files / "target.ply")


def cut(folder, name):
    text = (folder / name).read_text()
    (folder / name).write_text(text[: len(text) // 2])


def change(**fields):
    def write(folder, name):
        report = json.loads((folder / name).read_text())
        report.update(fields)
        (folder / name).write_text(json.dumps(report))

    return write


@pytest.mark.parametrize(
    "method, name, damage",
    [
        ("tracked", "report.json", cut),
        ("tracked", "report.json", lambda folder, name: (folder / name).unlink()),
        ("tracked", "report.json", change(hypotheses=[7])),
        ("tracked", "report.json", change(map={})),
        ("tracked", "report.json", change(seconds={"shapes": "long"})),
        ("tracked", "report.json", change(options={"method": "magic"})),
        ("tracked", "registered.ply", lambda folder, name: (folder / name).unlink()),
        ("tracked", "source_to_target.bary.txt", cut),
        ("tracked", "target_to_source.bary.txt", cut),
        ("paper", "levels.json", cut),
        ("paper", "levels.json", lambda folder, name: (folder / name).write_text("[{}, {}, {}]")),
        ("paper", "levels/01.many_to_one.txt", cut),
        ("paper", "levels/01.many_to_one.txt", lambda folder, name: (folder / name).unlink()),
    ],
)
def test_bad_folders_are_os_errors(files, tmp_path, method, name, damage):
    options = {"tracked": {"refinement": False}, "paper": {"levels": 2}}[method]
    result = isomatch.match(
        files / "source.off", files / "target.ply", method=method, **options
    )
    result.save(tmp_path, target_to_source=method == "tracked")
    damage(tmp_path, name)
    with pytest.raises(OSError, match=name.split(".")[0]):
        isomatch.load(tmp_path)
    with pytest.raises(OSError, match="report.json: cannot be opened"):
        isomatch.load(tmp_path / "absent")
