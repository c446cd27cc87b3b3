# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Shared libraries of programs: which they are, how they get other names and places."""

import hashlib
import os
import platform as machine
import re
import subprocess

# What a manylinux platform has (PEP 600), as far as we use it.
EVERYWHERE = re.compile(r"(ld-linux.*|linux-vdso|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+))\.so\.\d+")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed_by(files):
    """The path of each library that has to come along, by the name it is asked for."""
    lines = "".join(output_of("ldd", file) for file in files)
    found = dict(re.findall(r"^\s*(\S+) => (/\S+)", lines, re.MULTILINE))
    missing = re.findall(r"^\s*(\S+) => not found", lines, re.MULTILINE)
    if missing:
        raise SystemExit(f"bundle.py: {', '.join(missing)} cannot be found")
    return {name: path for name, path in sorted(found.items()) if not EVERYWHERE.fullmatch(name)}


def unique_name(path):
    """A name that no other package's copy of the library has: the process would share it."""
    name = os.path.basename(os.path.realpath(path))
    with open(path, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()[:8]
    stem, _, rest = name.partition(".so")
    return f"{stem}-{digest}.so{rest}"


def patch(file, *change):
    """One change at a time: patchelf 0.14 confuses the texts of several."""
    output_of("patchelf", *change, file)


def rename(library):
    patch(library, "--set-soname", library.name)


def look_in(folder, file, names):
    """Lets a binary take the libraries that have new names from a folder."""
    for name in set(output_of("patchelf", "--print-needed", file).split()) & set(names):
        patch(file, "--replace-needed", name, names[name])
    patch(file, "--set-rpath", f"$ORIGIN/{os.path.relpath(folder, file.parent)}")


def debian_package(path):
    """The package whose file a library is; its own folder may be linked, as /lib is."""
    real = os.path.realpath(path).removeprefix("/usr")
    return output_of("dpkg-query", "--search", f"*{real}").partition(":")[0]


def platform():
    """This machine's glibc, such as manylinux_2_36_x86_64: libstdc++ is as old as that is."""
    minor = machine.libc_ver()[1].partition(".")[2]
    return f"manylinux_2_{minor}_{machine.machine()}"
