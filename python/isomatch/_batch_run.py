# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""`isomatch batch` as a process, for `batch`: its progress and its errors."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple, Optional, Tuple

from . import _core
from ._program import find_program

#: How soon Ctrl-C, the end and a line of the log are noticed.
_POLL_SECONDS = 0.05
#: Exit codes of the program.
_SUCCESS, _BAD_INPUT, _PARTLY_FAILED = 0, 2, 3


class Job(NamedTuple):
    """What the processes of a batch have in common; goes to other machines."""

    folder: str
    #: With a pair a line, in the folder.
    list: str
    words: Tuple[str, ...]


def option_words(options):
    """Words of the command line for keywords, those that are not the default."""
    defaults = {name: default for name, default, _ in _core.options["tracked"]}
    words = []
    for name, value in options.items():
        flag, default = name.replace("_", "-"), defaults.get(name, False)
        if isinstance(default, bool):
            if not isinstance(value, bool):
                raise TypeError(f"{name}: expected a bool, not {value!r}")
            words += [("--" if value else "--no-") + flag] if value != default else []
        elif value != default:
            words += ["--" + flag, str(value)]
    return words


def _log_lines(log, start):
    try:
        with open(log, "rb") as file:
            file.seek(start)
            return file.read().count(b"\n")
    except FileNotFoundError:
        return 0


def _size(path):
    return path.stat().st_size if path.exists() else 0


def _stop(process):
    """As Ctrl-C does it, and at once if that takes long."""
    process.send_signal(signal.SIGINT)
    try:
        process.wait(5)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _fail(code, message, job):
    """Raises what the program's end means."""
    text = message.strip().removeprefix("isomatch: ")
    if code == _BAD_INPUT:
        # Of a file the message begins with its name.
        is_file = text.startswith((job.folder, job.list))
        raise OSError(text) if is_file else ValueError(text)
    if code == 128 + signal.SIGINT:
        raise KeyboardInterrupt
    if code < 0 or code > 128:
        number = -code if code < 0 else code - 128
        text = f"isomatch batch was ended by {signal.Signals(number).name}"
    raise RuntimeError(text or f"isomatch batch ended with {code}")


def run(job: Job, *words: str, log: Optional[str] = None, watch=None) -> None:
    """Runs it to its end, in which some pairs may have failed. `watch` is called from time to time
    with the number of lines that came to `log`; what it raises ends the program. That ends with
    this process as well, however this ends."""
    program = find_program()
    if program is None:
        raise FileNotFoundError("isomatch batch: the command line program is not installed")
    tied = str(Path(__file__).with_name("_tied.py"))
    start = [sys.executable, "-I", "-S", tied, str(os.getpid()), os.path.abspath(program)]
    command = ["batch", job.list, "-o", job.folder, "--quiet", *job.words, *words]
    log_path = Path(job.folder, log) if log else None
    before = _size(log_path) if log_path else 0
    with tempfile.TemporaryFile() as errors:
        # Ctrl-C in a terminal reaches this process alone, which passes it on.
        process = subprocess.Popen(
            start + command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=errors,
            start_new_session=True,
        )
        try:
            while process.poll() is None:
                if watch:
                    watch(_log_lines(log_path, before) if log_path else 0)
                time.sleep(_POLL_SECONDS)
        except BaseException:
            _stop(process)
            raise
        errors.seek(0)
        message = errors.read().decode(errors="surrogateescape")
    if process.returncode not in (_SUCCESS, _PARTLY_FAILED):
        _fail(process.returncode, message, job)
