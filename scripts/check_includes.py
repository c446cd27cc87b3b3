#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Holds the picture of CONTRIBUTING.md against the sources: which room may include which.

Prints each include that leads up or sideways, and ends with 1 if there is one.
Usage: scripts/check_includes.py
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
#: From the bottom up; rooms of one floor may include each other, but for the faces.
FLOORS = (
    ("", "mesh", "maps", "geometry"),
    ("io", "geodesics", "synth"),
    ("shape",),
    ("elastic", "spectral", "measure", "carry"),
    ("methods", "paper", "tracked"),
    ("group",),
    ("results",),
    ("program",),
    ("tools", "python", "baselines", "bench"),
)
FACES = FLOORS[-1]
#: Lists and kinds of options and values that files and programs need to know of.
ALLOWED = {("", "option_fields.h"), ("io", "isomatch/carry/transfer.h")}
#: Private rooms that those outside of `src` may see.
TOOLBOX = {"results": {"geometry"}, "baselines": None, "bench": None}
PLACES = ("include", "src", ".", "tools", "python/src", "baselines")


def room_of(path):
    """The room of a file, and whether it is private to the library."""
    parts = path.relative_to(ROOT).parts
    if parts[0] == "include":
        return parts[2] if len(parts) > 3 else "", False
    if parts[0] == "src":
        return parts[1] if len(parts) > 2 else "", True
    return parts[0], False


def floor_of(room):
    return next(level for level, rooms in enumerate(FLOORS) if room in rooms)


def target_of(path, name):
    for place in (path.parent, *(ROOT / place for place in PLACES)):
        if (place / name).is_file():
            return (place / name).resolve()
    return None


def complaint(path, name):
    """What is wrong with the include, None if it is right."""
    target = target_of(path, name)
    if target is None:
        return None
    (room, _), (other, is_private) = room_of(path), room_of(target)
    if room == other or (room, name) in ALLOWED or (room, path.name) in ALLOWED:
        return None
    if floor_of(other) > floor_of(room) or room in FACES and other in FACES:
        return "leads up"
    outside = floor_of(room) > floor_of("group")
    if outside and is_private and TOOLBOX.get(room, {}) is not None:
        return None if other in TOOLBOX.get(room, set()) else "sees a private header"
    return None


def main():
    found = 0
    for folder in ("include", "src", "results", "program", *FACES):
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            for name in re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE):
                wrong = complaint(path, name)
                if wrong:
                    print(f"{path.relative_to(ROOT)}: {wrong}: {name}")
                    found += 1
    sys.exit(1 if found else 0)


main()
