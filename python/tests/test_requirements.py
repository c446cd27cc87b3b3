# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What a Python is told that cannot load the package, and the program run as a module."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import isomatch

PACKAGE = Path(isomatch.__file__).parent


def run(*arguments, folder=PACKAGE.parent):
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    command = [sys.executable, *arguments]
    return subprocess.run(command, env=environment, capture_output=True, text=True)


def test_python_without_numpy_is_named():
    error = run("-S", "-c", "import isomatch").stderr
    reason = f"isomatch needs numpy, which {sys.executable} does not have; use Debian's own"
    assert error.splitlines()[-1].startswith(f"ModuleNotFoundError: {reason}")


def test_python_that_it_is_not_built_for_is_named(tmp_path):
    shutil.copytree(PACKAGE, tmp_path / "isomatch", ignore=shutil.ignore_patterns("_core*", "bin"))
    (tmp_path / "isomatch" / "_core.cpython-39-x86_64-linux-gnu.so").touch()
    error = run("-c", "import isomatch", folder=tmp_path).stderr
    reason = f"this isomatch is built for cpython-39, not for {sys.executable}; use Debian's own"
    assert error.splitlines()[-1].startswith(f"ModuleNotFoundError: {reason}")


def test_module_is_the_program():
    assert run("-m", "isomatch", "--version").stdout == f"isomatch {isomatch.__version__}\n"
    failed = run("-m", "isomatch", "info", "missing.off")
    assert failed.returncode == 2 and failed.stderr.startswith("isomatch: missing.off: ")
