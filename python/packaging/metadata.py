# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""The folder NAME-VERSION.dist-info, by which pip knows a package, made from pyproject.toml."""

import re
import shutil
import tomllib


def read_version(root):
    text = (root / "CMakeLists.txt").read_text()
    return re.search(r"project\(isomatch VERSION ([\d.]+)", text)[1]


def describe(project, version):
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {version}",
        f"Summary: {project['description']}",
        f"License: {project['license']['text']}",
        f"Requires-Python: {project['requires-python']}",
        *(f"Requires-Dist: {requirement}" for requirement in project["dependencies"]),
    ]
    return "\n".join(lines) + "\n"


def describe_wheel(tag):
    return f"Wheel-Version: 1.0\nGenerator: isomatch\nRoot-Is-Purelib: false\nTag: {tag}\n"


def list_scripts(scripts):
    return "[console_scripts]\n" + "".join(f"{name} = {call}\n" for name, call in scripts.items())


def write_dist_info(root, folder, tag):
    project = tomllib.loads((root / "pyproject.toml").read_text())["project"]
    version = read_version(root)
    info = folder / f"{project['name']}-{version}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(describe(project, version))
    (info / "WHEEL").write_text(describe_wheel(tag))
    (info / "entry_points.txt").write_text(list_scripts(project["scripts"]))
    shutil.copy(root / "LICENSE", info)
    return info
