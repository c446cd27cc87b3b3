# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Takes into a wheel the shared libraries that it needs, so that it runs where they are not
installed. What every Linux with the same glibc or a newer one has stays outside.

Usage: bundle.py WHEEL FOLDER; prints the name of the new wheel, in FOLDER.
"""

import re
import shutil
import sys
import tempfile
import zipfile
from pathlib import Path

import libraries
import wheel_file


def unpack(wheel, folder):
    with zipfile.ZipFile(wheel) as archive:
        for entry in archive.infolist():
            Path(archive.extract(entry, folder)).chmod(entry.external_attr >> 16)


def is_binary(file):
    with file.open("rb") as content:
        return content.read(4) == b"\x7fELF"


def binaries(content):
    return [file for file in content.rglob("*") if file.is_file() and is_binary(file)]


def bundle(content):
    """Copies the libraries into isomatch.libs, and lets everything look for them there."""
    found = libraries.needed_by(binaries(content))
    folder = content / "isomatch.libs"
    folder.mkdir()
    names = {name: libraries.unique_name(path) for name, path in found.items()}
    for name, path in found.items():
        shutil.copy(path, folder / names[name])
        libraries.rename(folder / names[name])
    for file in binaries(content):
        libraries.look_in(folder, file, names)
    return found.values()


def add_licenses(info, paths):
    """What the libraries' authors want to be passed on with them."""
    for path in paths:
        package = libraries.debian_package(path)
        shutil.copy(f"/usr/share/doc/{package}/copyright", info / f"LICENSE.{package}")


def replace_tag(info, platform):
    """The platform in the wheel's own description; returns the new tag."""
    text = (info / "WHEEL").read_text()
    [tag] = re.findall(r"Tag: (.*)", text)
    new_tag = f"{tag.rpartition('-')[0]}-{platform}"
    (info / "WHEEL").write_text(text.replace(tag, new_tag))
    return new_tag


def main(wheel, output):
    with tempfile.TemporaryDirectory() as folder:
        content = Path(folder)
        unpack(wheel, content)
        [info] = content.glob("*.dist-info")
        (info / "RECORD").unlink()
        add_licenses(info, bundle(content))
        tag = replace_tag(info, libraries.platform())
        name = f"{info.stem}-{tag}.whl"
        wheel_file.write_wheel(content, Path(output, name))
        print(name)


main(*sys.argv[1:])
