# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Runs a program that dies with the process that started it, even if that is killed.

Usage: _tied.py PARENT PROGRAM [ARGUMENT]...
"""

import ctypes
import os
import signal
import sys

PR_SET_PDEATHSIG = 1


def main():
    parent, program = int(sys.argv[1]), sys.argv[2]
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL, 0, 0, 0)
    # It may be gone already.
    if os.getppid() != parent:
        sys.exit(1)
    os.execv(program, ["isomatch", *sys.argv[3:]])


if __name__ == "__main__":
    main()
