# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What isomatch warns of."""

import sys
import warnings

PACKAGE = __name__.rpartition(".")[0]


class MatchWarning(UserWarning):
    """What was given, or what came out, may not be what it seems: a defect of a mesh, an ambiguous
    choice among maps, labels given as floats. It goes through `warnings`, where
    `warnings.simplefilter("ignore", isomatch.MatchWarning)` silences it."""


def warn(message):
    """Warns at the line that called the package."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__package__") == PACKAGE:
        level, frame = level + 1, frame.f_back
    warnings.warn(message, MatchWarning, stacklevel=level)
