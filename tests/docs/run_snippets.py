#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Runs the snippets of a page of the documentation.

A snippet is a fenced block after a comment. `<!-- run: shell -->` and `<!-- run: python -->` are
run, those of a language together and in order, in one folder; `<!-- run: shell, page -->` only if
the program can make reports; `<!-- quote: FILE -->` must occur in FILE of the repository.

Usage: run_snippets.py PAGE WORK_FOLDER [--page]
"""

import pathlib
import re
import shutil
import subprocess
import sys

SNIPPET = re.compile(r"<!-- (run|quote): (.*?) -->\n```\w+\n(.*?)```\n", re.DOTALL)
COMMANDS = {"shell": ["bash", "-euxo", "pipefail", "-c"], "python": [sys.executable, "-c"]}
REPOSITORY = pathlib.Path(__file__).parents[2]


def check_marked(text):
    """Every block in a language says what becomes of it."""
    blocks = len(re.findall(r"^```\w+$", text, re.MULTILINE))
    if blocks != len(SNIPPET.findall(text)):
        sys.exit("a block is not marked with what to do with it")


def check_quote(file, code):
    if code not in (REPOSITORY / file).read_text():
        sys.exit(f"this is not in {file}:\n{code}")


def run(language, code, folder):
    print(f"== {language}\n{code}", flush=True)
    if subprocess.run([*COMMANDS[language], code], cwd=folder).returncode != 0:
        sys.exit(f"a {language} snippet failed")


def main(page, folder, has_page):
    text = pathlib.Path(page).read_text()
    check_marked(text)
    shutil.rmtree(folder, ignore_errors=True)
    pathlib.Path(folder).mkdir(parents=True)
    code = {language: "" for language in COMMANDS}
    for kind, what, body in SNIPPET.findall(text):
        language, _, condition = what.partition(", ")
        if kind == "quote":
            check_quote(what, body)
        elif not condition or has_page:
            code[language] += body
    for language in COMMANDS:
        if code[language]:
            run(language, code[language], folder)


main(sys.argv[1], sys.argv[2], "--page" in sys.argv)
