# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Where the command line program is."""

import shutil
from pathlib import Path


def find_program():
    """Its path, None where it is not installed."""
    beside = Path(__file__).with_name("bin") / "isomatch"
    # Debian's packages have it apart.
    return str(beside) if beside.exists() else shutil.which("isomatch")
