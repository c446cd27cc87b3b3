# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""`python -m isomatch`, and the command `isomatch` that pip installs: the command line program."""

import os
import sys

from isomatch._program import find_program


def main():
    program = find_program()
    if program is None:
        sys.exit("isomatch: the command line program is not installed")
    # In place of this process, so that signals and exit codes are the program's own.
    os.execv(program, ["isomatch", *sys.argv[1:]])


if __name__ == "__main__":
    main()
