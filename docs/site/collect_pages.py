#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Collects what Sphinx makes the site of: the pages of docs, a page a public header, and a page of
the program's options, all with links that lead to pages of the site.

The navigation is what index.md links to, section by section, and under the page of the headers what
that page links to.

Usage: collect_pages.py ISOMATCH FOLDER
"""

import pathlib
import posixpath
import re
import shutil
import subprocess
import sys

REPOSITORY = pathlib.Path(__file__).parents[2]
DOCS = REPOSITORY / "docs"
HEADERS = REPOSITORY / "include/isomatch"
#: Pages that the repository keeps elsewhere.
ELSEWHERE = {"CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}

LINK = re.compile(r"(?<!!)\[([^\]]*)\]\((?!\w+://|#)([^)#\s]+)(#[^)]*)?\)")
FENCE = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
ENTRY = re.compile(r"^(?:- |\| )\[[^\]]*\]\(([^)#]+\.md)\)", re.MULTILINE)
CODE_MARK = re.compile(r"<!-- (?:run|quote): .*? -->\n")
SECTION = re.compile(r"^## (.*)$", re.MULTILINE)


def page_of(path):
    """Where a file of the repository is on the site, None if it is not there."""
    if path.startswith("docs/"):
        return path[len("docs/") :]
    if path.startswith("include/isomatch/"):
        return f"headers/{pathlib.Path(path).stem}.md"
    return ELSEWHERE.get(path)


def moved_link(match, origin, page):
    """A link in the file `origin` as one in `page`; text alone if the site has not got the goal."""
    text, goal, anchor = match[1], match[2], match[3] or ""
    path = posixpath.normpath(posixpath.join(posixpath.dirname(origin), goal))
    if not (REPOSITORY / path).exists() and path != "docs/commands.md":
        sys.exit(f"{origin}: there is no {path}")
    there = page_of(path)
    if there is None or (REPOSITORY / path).is_dir():
        return text
    return f"[{text}]({posixpath.relpath(there, posixpath.dirname(page) or '.')}{anchor})"


def with_moved_links(text, origin, page):
    parts = FENCE.split(CODE_MARK.sub("", text))
    for i in range(0, len(parts), 2):
        parts[i] = LINK.sub(lambda match: moved_link(match, origin, page), parts[i])
    return "".join(parts)


def write(folder, page, text):
    path = folder / page
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def toctree(caption, pages):
    lines = ["```{toctree}", ":hidden:", *([f":caption: {caption}"] if caption else []), *pages]
    return "\n" + "\n".join([*lines, "```"]) + "\n"


def linked_pages(text):
    """Pages that a text links to at the beginning of an entry of a list or a table's row."""
    return ENTRY.findall(text)


def with_navigation(page, text):
    if page == "index.md":
        titles = SECTION.findall(text)
        bodies = SECTION.split(text)[2::2]
        trees = [toctree(t, linked_pages(b)) for t, b in zip(titles, bodies) if linked_pages(b)]
        return text + "".join(trees)
    if page == "headers.md":
        return text + toctree("", linked_pages(text))
    return text


def header_page(header):
    name = header.relative_to(HEADERS.parent)
    return (
        f"# {header.name}\n\n```cpp\n#include \"{name}\"\n```\n\n"
        f"```{{doxygenfile}} {name}\n```\n"
    )


def commands_page(program):
    """What the program says of itself."""

    def help_of(*subcommand):
        run = [program, *subcommand, "--help"]
        return subprocess.run(run, check=True, capture_output=True, text=True).stdout.rstrip()

    text = (DOCS / "site/commands.md").read_text()
    list_of_commands = help_of().split("Subcommands:")[1].split("\n\n")[0]
    for name in re.findall(r"^  (\w+) ", list_of_commands, re.MULTILINE):
        # The default is that of the machine at hand.
        usage = re.sub(r"=\d+ +Threads to use", "   Threads to use; all by default", help_of(name))
        text += f"\n## isomatch {name}\n\n```text\n{usage}\n```\n"
    return text


def main(program, folder):
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    pages = [*DOCS.glob("*.md"), *DOCS.glob("results/*.md")]
    sources = {str(page.relative_to(DOCS)): page for page in pages}
    sources |= {page: REPOSITORY / name for name, page in ELSEWHERE.items()}
    for page, source in sources.items():
        text = with_moved_links(source.read_text(), str(source.relative_to(REPOSITORY)), page)
        write(folder, page, with_navigation(page, text))
    for header in sorted(HEADERS.rglob("*.h")):
        write(folder, f"headers/{header.stem}.md", header_page(header))
    write(folder, "commands.md", commands_page(program))
    shutil.copytree(DOCS / "pictures", folder / "pictures")
    for plot in DOCS.glob("results/*.svg"):
        shutil.copy(plot, folder / "results")


main(*sys.argv[1:])
