# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Progress, cancellation, and other threads."""
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import isomatch


@pytest.fixture(scope="module")
def large():
    """A pair that keeps a core busy for a while."""
    return [isomatch.Shape(isomatch.synthesize(vertices=12000, pose=p)) for p in (1, 2)]


def test_progress_rises_to_the_end(pose1, pose2):
    reports = []
    isomatch.match(pose1, pose2, progress=lambda *report: reports.append(report))
    fractions = [fraction for fraction, _ in reports]
    assert fractions == sorted(fractions)
    assert len({stage for _, stage in reports}) > 2
    assert 0 <= fractions[0] and fractions[-1] <= 1


def test_progress_is_called_in_the_calling_thread(pose1):
    threads = set()
    isomatch.synthesize(vertices=20000, progress=lambda *_: threads.add(threading.get_ident()))
    assert threads <= {threading.get_ident()}


def test_an_exception_in_progress_ends_the_work(large):
    class Enough(Exception):
        pass

    def stop(fraction, stage):
        raise Enough

    start = time.perf_counter()
    isomatch.match(*large)
    whole = time.perf_counter() - start
    start = time.perf_counter()
    with pytest.raises(Enough):
        isomatch.match(*large, progress=stop)
    assert time.perf_counter() - start < whole / 2


def test_other_threads_go_on(large):
    done = threading.Event()
    result = []

    def work():
        result.append(isomatch.match(*large))
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    ticks = 0
    while not done.is_set():
        ticks += 1
        time.sleep(0.001)
    thread.join()
    # Holding the interpreter's lock would leave a handful.
    assert ticks > 50 and len(result) == 1


INTERRUPTED = """
import isomatch, sys
pair = [isomatch.Shape(isomatch.synthesize(vertices=12000, pose=p)) for p in (1, 2)]
print("ready", flush=True)
try:
    while True:
        isomatch.match(*pair)
except KeyboardInterrupt:
    print("interrupted")
    # The library is as good as before.
    small = isomatch.synthesize(vertices=1000)
    print(len(isomatch.match(small, small).source_to_target) == len(small.vertices))
"""


def test_ctrl_c_interrupts():
    process = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    output, _ = process.communicate(timeout=120)
    assert output == "interrupted\nTrue\n"


def test_the_environment_stays_as_it_was():
    environment = {k: v for k, v in os.environ.items() if k != "OMP_WAIT_POLICY"}
    command = "import isomatch, os; print(os.environ.get('OMP_WAIT_POLICY'))"
    output = subprocess.run(
        [sys.executable, "-c", command], env=environment, capture_output=True, text=True
    ).stdout
    assert output == "None\n"
