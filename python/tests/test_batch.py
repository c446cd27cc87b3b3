# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Many pairs, in a process and on the workers of Dask."""
import itertools
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import isomatch

#: Options that make matches quick.
QUICK = {"refinement": False, "elastic_judging": False}
FLAGS = ["--no-refinement", "--no-elastic-judging"]


def lump(seed, rings=6, segments=8):
    """An ellipsoid with a bump, a few vertices."""
    theta = np.repeat(np.pi * np.arange(1, rings) / rings, segments)
    phi = np.tile(2 * np.pi * np.arange(segments) / segments, rings - 1)
    bump = 1 + 0.25 * np.exp(-3 * ((theta - 1) ** 2 + (phi - 1) ** 2))
    sphere = [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)]
    axes = [1 + 0.07 * seed, 0.7 - 0.04 * seed, 0.4]
    around = np.column_stack(sphere) * axes * bump[:, None]
    last = 1 + len(around)
    faces = []
    for j in range(segments):
        k = (j + 1) % segments
        faces += [[0, 1 + j, 1 + k], [last, last - segments + k, last - segments + j]]
        for first in range(1, last - segments, segments):
            a, b, c, d = first + j, first + k, first + j + segments, first + k + segments
            faces += [[a, c, d], [a, d, b]]
    return np.vstack([[0, 0, 0.4], around, [0, 0, -0.4]]), faces


@pytest.fixture(scope="module")
def shapes(tmp_path_factory):
    """Files of small shapes."""
    folder = tmp_path_factory.mktemp("shapes")
    files = [folder / f"s{number}.off" for number in range(4)]
    for number, file in enumerate(files):
        isomatch.write_mesh(file, lump(number))
    return files


@pytest.fixture(scope="module")
def pairs(shapes):
    return list(itertools.permutations(shapes, 2))


@pytest.fixture(scope="module")
def by_program(pairs, program, tmp_path_factory):
    """What the program leaves."""
    folder = tmp_path_factory.mktemp("by_program")
    (folder / "list.csv").write_text("".join(f"{a},{b}\n" for a, b in pairs))
    program("batch", folder / "list.csv", "-o", folder / "matched", "--quiet", *FLAGS)
    return folder / "matched"


def files_of(folder):
    """The files of maps, by name, and what is in them."""
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in pathlib.Path(folder).glob("*/*")
        if path.name != "report.json"
    }


def test_leaves_what_the_program_leaves(pairs, by_program, tmp_path):
    result = isomatch.batch(pairs, tmp_path / "matched", **QUICK)
    assert files_of(tmp_path / "matched") == files_of(by_program) and len(result) == 12
    assert result.table[0].keys() == isomatch.Batch(by_program).table[0].keys()
    assert not result.failed and list(result) == [f"{a.stem}__{b.stem}" for a, b in pairs]


def test_a_name_gives_the_match(pairs, tmp_path):
    source, target = pairs[0]
    result = isomatch.batch([(source, target, "mine")], tmp_path, **QUICK)
    assert result.table[0]["source_vertices_matched"] == np.count_nonzero(
        result["mine"].source_to_target >= 0
    )
    expected = isomatch.match(source, target, **QUICK)
    assert np.array_equal(result["mine"].source_to_target, expected.source_to_target)
    with pytest.raises(KeyError):
        result["yours"]


def test_a_bad_file_fails_its_pairs(pairs, tmp_path):
    result = isomatch.batch(
        [pairs[0], (pairs[0][0], "missing.off")], tmp_path / "matched", threads=1, **QUICK
    )
    assert [row["name"] for row in result.failed] == ["s0__missing"]
    assert "missing.off" in result.failed[0]["error"] and result.failed[0]["stretch"] is None
    with pytest.raises(OSError, match="missing.off"):
        result["s0__missing"]


def test_goes_on_if_it_is_told_to(pairs, tmp_path):
    isomatch.batch(pairs[:1], tmp_path, **QUICK)
    with pytest.raises(OSError, match="resume=True"):
        isomatch.batch(pairs[:2], tmp_path, **QUICK)
    isomatch.batch(pairs[:2], tmp_path, resume=True, **QUICK)
    log = (tmp_path / "batch.log").read_text()
    assert log.count("(earlier)") == 1 and len(log.splitlines()) == 3
    with pytest.raises(OSError, match="other options"):
        isomatch.batch(pairs[:2], tmp_path, resume=True)


def test_wrong_input_is_told_before_any_work(pairs, tmp_path):
    place = tmp_path / "matched"
    with pytest.raises(ValueError, match="two have the name 's0__s1'"):
        isomatch.batch(pairs[:1] * 2, place)
    with pytest.raises(ValueError, match="there is none"):
        isomatch.batch([], place)
    with pytest.raises(ValueError, match="expected .source, target"):
        isomatch.batch([pairs[0][:1]], place)
    with pytest.raises(ValueError, match="alternatives"):
        isomatch.batch(pairs, place, alternatives=-1)
    with pytest.raises(ValueError, match="threads"):
        isomatch.batch(pairs, place, threads=0)
    with pytest.raises(TypeError, match="did you mean 'refinement'"):
        isomatch.batch(pairs, place, refinment=False)
    with pytest.raises(TypeError, match="whole: expected a bool"):
        isomatch.batch(pairs, place, whole="yes")
    assert not place.exists()
    place.write_text("a file")
    with pytest.raises(OSError):
        isomatch.batch(pairs, place)


def test_progress_counts_pairs(pairs, tmp_path):
    reports = []
    isomatch.batch(pairs, tmp_path, threads=1, progress=lambda *r: reports.append(r), **QUICK)
    fractions = [fraction for fraction, _ in reports]
    assert fractions == sorted(fractions) and len(set(fractions)) > 2
    assert all(0 < fraction <= 1 for fraction in fractions)


INTERRUPTED = """
import isomatch, itertools, sys
try:
    isomatch.batch(list(itertools.permutations(sys.argv[2:], 2)), sys.argv[1], threads=1)
except KeyboardInterrupt:
    print("interrupted")
"""


def start_batch(folder, shapes):
    """A process that is in the middle of a batch."""
    process = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, folder, *shapes], stdout=subprocess.PIPE, text=True
    )
    wait_for(lambda: (folder / "batch.log").exists() and (folder / "batch.log").read_text())
    return process


def wait_for(condition):
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)


def running(folder):
    """Whether a process has the folder among its arguments."""
    command = ["pgrep", "--full", f"batch {folder}/pairs-listed.csv"]
    return subprocess.run(command, stdout=subprocess.DEVNULL).returncode == 0


def test_ctrl_c_stops_the_program(shapes, tmp_path):
    process = start_batch(tmp_path, shapes)
    assert running(tmp_path)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=60)
    assert output == "interrupted\n" and not running(tmp_path)
    assert not (tmp_path / "pairs.csv").exists() and not list(tmp_path.glob(".*"))


def test_the_program_dies_with_python(shapes, tmp_path):
    process = start_batch(tmp_path, shapes)
    process.kill()
    process.communicate(timeout=60)
    wait_for(lambda: not running(tmp_path))


@pytest.fixture(scope="module")
def client():
    """Two workers, a process each."""
    distributed = pytest.importorskip("distributed", reason="distributed is not installed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        yield client


def logged(folder):
    """Names of pairs that shares matched, and of those that they found finished."""
    lines = [line for log in folder.glob("batch-*-of-*.log") for line in log.open()]
    old = [line.split(":")[0] for line in lines if line.endswith("(earlier)\n")]
    return [line.split(":")[0] for line in lines if not line.endswith("(earlier)\n")], old


def test_a_worker_that_is_killed_loses_no_pair(client, pairs, by_program, tmp_path):
    before = client.run(os.getpid)

    def kill():
        wait_for(lambda: any(log.stat().st_size for log in tmp_path.glob("batch-*.log")))
        os.kill(next(iter(before.values())), signal.SIGKILL)

    killer = threading.Thread(target=kill)
    killer.start()
    result = isomatch.batch(pairs, tmp_path, client=client, shards=4, **QUICK)
    killer.join()
    client.wait_for_workers(2)
    assert set(client.run(os.getpid).values()) != set(before.values())
    assert files_of(tmp_path) == files_of(by_program) and not result.failed
    assert [row["name"] for row in result.table] == [f"{a.stem}__{b.stem}" for a, b in pairs]
    new, old = logged(tmp_path)
    assert len(set(new)) == len(new) and set(new + old) == set(result)
    # Of a pair that was finished when its process died there may be no line.
    assert len(new) >= len(pairs) - 1


def test_errors_of_workers_are_those_of_the_program(client, pairs, tmp_path):
    with pytest.raises(ValueError, match="alternatives"):
        isomatch.batch(pairs, tmp_path / "matched", client=client, alternatives=-1)
    assert not (tmp_path / "matched").exists()
    with pytest.raises(ValueError, match="shards"):
        isomatch.batch(pairs, tmp_path / "matched", client=client, shards=0)


def test_workers_go_on(client, pairs, tmp_path):
    isomatch.batch(pairs[:2], tmp_path, client=client, **QUICK)
    with pytest.raises(OSError, match="resume=True"):
        isomatch.batch(pairs[:2], tmp_path, client=client, **QUICK)
    result = isomatch.batch(pairs[:4], tmp_path, client=client, resume=True, **QUICK)
    assert len(logged(tmp_path)[0]) == 4 and not result.failed


def test_what_ends_the_call_ends_the_tasks(client, pairs, tmp_path):
    class Enough(Exception):
        pass

    def stop(fraction, stage):
        raise Enough

    with pytest.raises(Enough):
        isomatch.batch(pairs, tmp_path, client=client, shards=4, progress=stop, **QUICK)
    wait_for(lambda: not running(tmp_path))
    matched = len(list(tmp_path.glob("*__*")))
    time.sleep(1)
    assert len(list(tmp_path.glob("*__*"))) == matched < len(pairs)


def test_a_packed_batch_gives_the_same_matches(pairs, by_program, program, tmp_path):
    if "--packed" not in program("batch", "--help"):
        pytest.skip("this program has no --packed")
    place = tmp_path / "matched"
    result = isomatch.batch(pairs, place, packed=True, **QUICK)
    assert not (place / "s0__s1").exists() and not result.failed
    expected = isomatch.Batch(by_program)
    for name in ("s0__s1", "s3__s2"):
        assert np.array_equal(result[name].barycentric, expected[name].barycentric)
