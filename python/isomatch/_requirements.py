# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What Python has to be for the package to load."""

import sys
from importlib.util import find_spec
from pathlib import Path


def built_for():
    """The Pythons whose extension module is here, such as cpython-311."""
    tags = [file.name.split(".")[1] for file in Path(__file__).parent.glob("_core.*.so")]
    return ", ".join(sorted("-".join(tag.split("-")[:2]) for tag in tags)) or "no Python yet"


def check_python():
    """Says in a line what is missing; tracebacks of numpy's and the linker's do not."""
    if find_spec("isomatch._core") is None:
        problem = f"this isomatch is built for {built_for()}, not for {sys.executable}"
        remedy = "pip install ."
    elif find_spec("numpy") is None:
        problem = f"isomatch needs numpy, which {sys.executable} does not have"
        remedy = "pip install numpy"
    else:
        return
    raise ModuleNotFoundError(f"{problem}; use Debian's own /usr/bin/python3, or {remedy}")
