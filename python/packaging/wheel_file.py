# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Wheels: archives of what lies in site-packages, with a list of their files (PEP 427)."""

import base64
import hashlib
import sys
import sysconfig
import zipfile


def platform_tag():
    """The Python that runs, and its platform, such as cp311-cp311-linux_x86_64."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}{sys.abiflags}-{platform}"


def record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def add_file(archive, name, data, mode):
    # Without a time of its own, so that the same files give the same bytes.
    entry = zipfile.ZipInfo(name)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = mode << 16
    archive.writestr(entry, data)


def write_wheel(content, wheel):
    """Packs the folder `content`, which has a .dist-info without RECORD."""
    [info] = content.glob("*.dist-info")
    record = ""
    with zipfile.ZipFile(wheel, "w") as archive:
        for file in sorted(file for file in content.rglob("*") if file.is_file()):
            name = file.relative_to(content).as_posix()
            data = file.read_bytes()
            add_file(archive, name, data, file.stat().st_mode)
            record += record_line(name, data)
        name = f"{info.name}/RECORD"
        add_file(archive, name, record + f"{name},,\n", 0o100644)
