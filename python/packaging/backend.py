# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What pip calls to build the package (PEP 517, PEP 660): CMake compiles, the result is packed.

Nothing but Python's own modules is used, so that pip needs no network for Debian's Python. The
build folder is the release's: what is compiled there is not compiled again.
"""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import metadata
import wheel_file

ROOT = Path(__file__).parents[2]
BUILD = ROOT / "build/release"
INSTALLED = "lib/python3/dist-packages"  # ISOMATCH_PYTHON_FOLDER
HINT = "`scripts/install_packages.sh build python` installs what a build needs"


def get_requires_for_build_wheel(config_settings=None):
    # Debian 12 has a pybind11 for its own Python and older ones.
    return [] if sys.version_info < (3, 12) else ["pybind11>=2.13"]


get_requires_for_build_editable = get_requires_for_build_wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    return metadata.write_dist_info(ROOT, Path(metadata_directory), wheel_file.platform_tag()).name


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build_page()
    compile_package()
    with tempfile.TemporaryDirectory() as prefix:
        for part in ("python", "python_program"):
            run("cmake", "--install", BUILD, "--prefix", prefix, "--component", part, "--strip")
        return pack(Path(prefix, INSTALLED), wheel_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that only points to the build folder."""
    build_page()
    compile_package()
    with tempfile.TemporaryDirectory() as content:
        Path(content, "isomatch.pth").write_text(f"{BUILD / 'python'}\n")
        return pack(Path(content), wheel_directory)


def pack(content, wheel_directory):
    tag = wheel_file.platform_tag()
    metadata.write_dist_info(ROOT, content, tag)
    name = f"isomatch-{metadata.read_version(ROOT)}-{tag}.whl"
    wheel_file.write_wheel(content, Path(wheel_directory, name))
    return name


def build_page():
    """The page of `isomatch report`, if npm is there; everything else works without."""
    if shutil.which("npm") and subprocess.run([ROOT / "scripts/build_viewer.sh"]).returncode != 0:
        print("isomatch: no viewer, so the package will not make reports", file=sys.stderr)


def compile_package():
    # The Python that a virtual environment was made from: the same one for all of them.
    python = Path(sys.executable).resolve()
    run("cmake", "--preset", "release", "-DISOMATCH_BUILD_PYTHON=ON",
        f"-DPython_EXECUTABLE={python}", *pybind11_folder())
    run("cmake", "--build", BUILD, "--parallel", "--target", "isomatch_python_package")


def pybind11_folder():
    try:
        import pybind11
    except ModuleNotFoundError:
        return []  # CMake finds the system's.
    return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


def run(*command):
    try:
        subprocess.run(command, cwd=ROOT, check=True)
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        sys.exit(f"isomatch: {error}\n{HINT}")
