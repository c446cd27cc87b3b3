#!/usr/bin/env python3
"""Runs clang-tidy on the project's sources that changed since it last passed.

Most of clang-tidy's time goes into the headers of Eigen and of the standard library, so several
sources of the same target are checked as one. What passed is remembered under ~/.cache by its
content: that of the source, of the project's headers that it includes, of the flags, of .clang-tidy
and of the installed packages with headers.

Usage: scripts/tidy.py BUILD_FOLDER
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CLANG_TIDY = "clang-tidy-19"
# More would leave a core idle at the end.
LARGEST_BATCH = 12
# Clang does not accept this version of CGAL's headers; consumers are projects of their own.
LEFT_OUT = re.compile(r"tests/oracle/exact_geodesics\.cpp$|tests/consumer/|/CMakeFiles/")
CACHE = pathlib.Path(os.environ.get("XDG_CACHE_HOME", pathlib.Path.home() / ".cache"))
STAMPS = CACHE / "isomatch" / "tidy"
# What begins a line at namespace level, by the formatting that is checked before.
DEFINED_NAME = re.compile(
    r"^(?!namespace |using [\w:]+;)"
    r"(?:TEST(?:_[FP])?\((\w+, *\w+)|(?:class|struct|enum(?: class)?|using) (\w+)"
    r"|[A-Za-z_][^;={}()]*?[ &*>](\w+)(?:\(|\{| =|;|\[))", re.MULTILINE)


def clang_flags(entry):
    """The flags of a compile command that clang needs."""
    words = shlex.split(entry["command"])
    flags = []
    words = iter(words[next(i for i, w in enumerate(words) if w.endswith(("c++", "g++"))) + 1:])
    for word in words:
        if word in ("-o", "-c", "-include", "-MF", "-MT"):
            next(words)
        elif word.startswith(("-I", "-D", "-std")):
            flags.append(word)
        elif word == "-isystem":
            flags += [word, next(words)]
    return flags


def included(path, folders, seen):
    """All files of the project that `path` includes, itself first."""
    if path in seen:
        return
    seen.add(path)
    for name in re.findall(r'^#include "([^"]+)"', path.read_text(), re.MULTILINE):
        for folder in [path.parent, *folders]:
            header = folder / name
            if header.is_file():
                included(header.resolve(), folders, seen)
                break


def installed_packages():
    query = subprocess.run(["dpkg-query", "--show"], capture_output=True, text=True, check=False)
    return "\n".join(line for line in query.stdout.splitlines()
                     if re.match(r"lib.*-dev|clang|g\+\+|nlohmann|pybind11|python3-dev", line))


class Source:
    """A source, its flags, and the stamp it leaves when it has passed."""

    def __init__(self, entry, surroundings):
        self.path = pathlib.Path(entry["file"]).resolve()
        self.flags = clang_flags(entry)
        folders = [pathlib.Path(flag[2:]) for flag in self.flags
                   if flag.startswith(f"-I{ROOT}")]
        files = set()
        included(self.path, folders, files)
        content = hashlib.sha256(surroundings)
        content.update("\n".join(self.flags).replace(str(ROOT), "").encode())
        for file in sorted(files):
            content.update(file.relative_to(ROOT).as_posix().encode() + file.read_bytes())
        self.stamp = STAMPS / content.hexdigest()

    def names(self):
        return {next(filter(None, match)) for match in DEFINED_NAME.findall(self.path.read_text())}


def batches_of(sources):
    """Sources that can be compiled as one: of the same flags, and without a name in common."""
    batches = []
    for source in sources:
        names = source.names()
        for members, taken in batches:
            if (members[0].flags == source.flags and len(members) < LARGEST_BATCH
                    and not names & taken):
                members.append(source)
                taken |= names
                break
        else:
            batches.append(([source], names))
    return [members for members, _ in batches]


def run_tidy(paths, flags):
    """Returns whether it passed, and what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        file = paths[0]
        if len(paths) > 1:
            file = pathlib.Path(folder) / "batch.cpp"
            file.write_text("".join(
                f'#include "{path}"  // NOLINT(bugprone-suspicious-include)\n' for path in paths))
        command = [CLANG_TIDY, "--quiet", f"--config-file={ROOT}/.clang-tidy", str(file), "--",
                   *flags, "-w"]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    return run.returncode == 0, run.stdout + run.stderr


def check(batch):
    """Checks sources as one, and in halves if something was found; prints what remains."""
    passed, output = run_tidy([source.path for source in batch], batch[0].flags)
    if passed:
        for source in batch:
            source.stamp.touch()
    elif len(batch) > 1:
        middle = len(batch) // 2
        # Both, so that all findings are shown.
        results = [check(batch[:middle]), check(batch[middle:])]
        passed = all(results)
    else:
        print(output, flush=True)
    return passed


def main():
    build = pathlib.Path(sys.argv[1])
    version = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, check=True).stdout
    surroundings = (version + installed_packages().encode() +
                    (ROOT / ".clang-tidy").read_bytes() + pathlib.Path(__file__).read_bytes())
    STAMPS.mkdir(parents=True, exist_ok=True)
    entries = json.loads((build / "compile_commands.json").read_text())
    sources = [Source(entry, surroundings) for entry in entries
               if not LEFT_OUT.search(entry["file"])]
    unchecked = [source for source in sources if not source.stamp.exists()]
    batches = batches_of(unchecked)
    print(f"{len(unchecked)} of {len(sources)} sources to check, {len(batches)} at a time as one")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(check, sorted(batches, key=len, reverse=True)))
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
