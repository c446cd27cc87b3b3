# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Formulas as HTML, set by KaTeX when the site is built; names in comments of headers as links."""

import functools
import json
import pathlib
import re
import shutil
import subprocess

from docutils import nodes
from sphinx import addnodes
from sphinx.util.osutil import ensuredir

JAVASCRIPT = pathlib.Path("/usr/share/javascript")
KATEX = JAVASCRIPT / "katex"
SET_FORMULA = f"""
const katex = require("{KATEX}/katex.min.js");
process.stdout.write(katex.renderToString(...JSON.parse(process.argv[1])));
"""
#: In comments of headers, and outside, where words may mean something else.
NAME = re.compile(r"[A-Za-z_]\w*(::~?\w+)*(\(\))?$")
UNMISTAKABLE_NAME = re.compile(r"[A-Z]\w*(::\w+)*$|[a-z]+_\w+(\(\))?$")


@functools.lru_cache(maxsize=None)
def formula(tex, displayed):
    command = ["node", "-e", SET_FORMULA, json.dumps([tex, {"displayMode": displayed}])]
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def visit_formula(self, node):
    self.body.append(formula(node.astext(), False))
    raise nodes.SkipNode


def visit_displayed_formula(self, node):
    self.body.append(f'<div class="formula">{formula(node.astext(), True)}</div>')
    raise nodes.SkipNode


def copy_katex(folder):
    ensuredir(folder / "fonts")
    shutil.copy(KATEX / "katex.min.css", folder)
    for font in (KATEX / "fonts").glob("*.woff2"):
        shutil.copy(font, folder / "fonts")


def repair_theme(folder):
    """Debian's Furo expects a web server with other packages' files, and modules in JavaScript,
    which browsers do not load from disk. Its style has lost the rule that follows the reader's
    preference for dark pages."""
    style = folder / "styles/furo.css"
    imported = re.compile(r"^@import url\(/javascript/(.*?)\);")
    text = imported.sub(lambda match: (JAVASCRIPT / match[1]).read_text(), style.read_text())
    dark = re.search(r'body\[data-theme="dark"\] (\{.*?\})', text, re.DOTALL)[1]
    preferred = f'@media (prefers-color-scheme: dark) {{ body:not([data-theme="light"]) {dark} }}'
    style.write_text(f"{text}\n@media not print {{ {preferred} }}\n")
    script = folder / "scripts/furo.js"
    text = script.read_text().replace('import Gumshoe from "./gumshoe-patched.js";', "")
    script.write_text((folder / "scripts/gumshoe-patched.js").read_text() + text)


def complete_static_files(app, exception):
    if exception is None:
        folder = pathlib.Path(app.outdir) / "_static"
        copy_katex(folder / "katex")
        repair_theme(folder)


def parameters_around(node):
    """The parameters of the functions in whose comments it stands."""
    names = set()
    while node is not None:
        if isinstance(node, addnodes.desc):
            for parameter in node.findall(addnodes.desc_parameter):
                own = list(parameter.findall(addnodes.desc_sig_name))[-1:]
                names |= {name.astext() for name in own}
        node = node.parent
    return names


def link_names(app, doctree):
    """Makes `names` references, which lead to what they name if that stands in a header."""
    names = NAME if app.env.docname.startswith("headers/") else UNMISTAKABLE_NAME
    if app.env.docname == "python":
        return
    for literal in list(doctree.findall(nodes.literal)):
        text = literal.astext()
        if not names.match(text) or text in parameters_around(literal):
            continue
        reference = addnodes.pending_xref(
            "",
            refdomain="cpp",
            reftype="any",
            reftarget=text.removesuffix("()"),
            refexplicit=True,
            refdoc=app.env.docname,
            header_name=True,
        )
        literal.replace_self(reference)
        reference += literal


def keep_plain(app, env, node, contnode):
    """Other words are no broken references."""
    return contnode if node.get("header_name") else None


def setup(app):
    app.add_html_math_renderer(
        "katex", (visit_formula, None), (visit_displayed_formula, None)
    )
    app.config["html_math_renderer"] = "katex"
    app.add_css_file("katex/katex.min.css")
    app.connect("doctree-read", link_names)
    app.connect("missing-reference", keep_plain, priority=900)
    app.connect("build-finished", complete_static_files)
    return {"parallel_read_safe": True}
