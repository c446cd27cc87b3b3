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


def replacements(file, names):
    needed = output_of("patchelf", "--print-needed", file).split()
    return [word for name in needed if name in names
            for word in ("--replace-needed", name, names[name])]


def rename(library, names):
    """Gives a library its file's name, and lets it look for others beside itself."""
    output_of("patchelf", "--set-soname", library.name, "--set-rpath", "$ORIGIN",
              *replacements(library, names), library)


def look_in(file, folder, names):
    path = os.path.relpath(folder, file.parent)
    output_of("patchelf", "--set-rpath", f"$ORIGIN/{path}", *replacements(file, names), file)


def debian_package(path):
    """The package whose file a library is; its own folder may be linked, as /lib is."""
    real = os.path.realpath(path).removeprefix("/usr")
    return output_of("dpkg-query", "--search", f"*{real}").partition(":")[0]


def platform(files):
    """The oldest glibc that has all symbols that the files ask for: manylinux_2_36_x86_64."""
    versions = "".join(output_of("readelf", "--version-info", file) for file in files)
    minor = max(int(minor) for minor in re.findall(r"GLIBC_2\.(\d+)", versions))
    return f"manylinux_2_{minor}_{machine.machine()}"
