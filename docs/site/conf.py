# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""How Sphinx makes the site of the pages that collect_pages.py has collected."""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
REPOSITORY = pathlib.Path(__file__).parents[2]

project = "isomatch"
author = copyright = "2026 The isomatch authors"
release = version = re.search(
    r"VERSION (\d+\.\d+\.\d+)", (REPOSITORY / "CMakeLists.txt").read_text()
)[1]
root_doc = "index"
extensions = ["myst_parser", "breathe", "site_extension"]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
myst_url_schemes = ["http", "https"]

breathe_projects = {"isomatch": str(REPOSITORY / "build/docs_work/xml")}
breathe_default_project = "isomatch"
breathe_domain_by_extension = {"h": "cpp"}
breathe_show_include = False
primary_domain = "cpp"
highlight_language = "none"

# Names of other libraries, and what only the compiler needs to know.
nitpick_ignore_regex = [
    (r"cpp:.*", r"(std|Eigen)(::.*)?"),
    (r"cpp:.*", r"(uint64_t|size_t)"),
    (r"cpp:.*", r"[A-Z]\w*::(Queue|Parts|Close|Entry)|Queue|Parts|Close|Entry"),
    # What only the library sees of a shape.
    (r"cpp:.*", r"PreparedShape"),
]

html_theme = "furo"
html_title = f"isomatch {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_use_index = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0b5c8a", "color-brand-content": "#0b5c8a"},
    "dark_css_variables": {"color-brand-primary": "#6cb8e6", "color-brand-content": "#6cb8e6"},
}
pygments_style = "friendly"
pygments_dark_style = "native"
