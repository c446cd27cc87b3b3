#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Tables of docs/results/index.md that README and documents show as well, between marks.

Run as a program it checks that they are the same everywhere. Usage: bench/tables/blocks.py
"""

import re
import sys

from common import ROOT

PAGE = ROOT / "docs/results/index.md"
DOCUMENTS = (ROOT / "README.md", ROOT / "docs/paper.md")
END = "<!-- end -->"


def beginning(name):
    return f"<!-- {name}, made by bench/tables/index.py -->\n"


def block(name, text):
    return f"{beginning(name)}{text}\n{END}"


def pattern(name):
    return re.compile(re.escape(beginning(name)) + "(.*?)" + re.escape(END), re.DOTALL)


def copy_to_documents(texts):
    for path in DOCUMENTS:
        document = path.read_text()
        for name, text in texts.items():
            document = pattern(name).sub(lambda _: block(name, text), document)
        path.write_text(document)


def different():
    """Documents and blocks that are not as on the page."""
    page = PAGE.read_text()
    for path in DOCUMENTS:
        document = path.read_text()
        names = re.findall(beginning(r"(\w+)"), document)
        if not names:
            yield path, "no block"
        for name in names:
            if pattern(name).findall(document) != pattern(name).findall(page):
                yield path, name


if __name__ == "__main__":
    wrong = [f"{path.relative_to(ROOT)}: {name} differs from {PAGE.relative_to(ROOT)}"
             for path, name in different()]
    sys.exit("\n".join(wrong) or 0)
