# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""What the pages of matches and of groups have in common."""

import html
import os

from . import _core


def written_or_returned(make_page, path, shapes):
    """What `make_page()` returns, if there is no path; otherwise it is written there. Raises what
    stands against the path before it is made."""
    if path is not None:
        _core.check_page(os.fsencode(path), [os.fsencode(shape.path or "") for shape in shapes])
    page = make_page()
    if path is None:
        return page
    _core.write_file(os.fsencode(path), page)


def shown_in_a_notebook(result, title):
    """The page of a result in a frame, or its `repr` where there are no pages."""
    if not _core.has_page():
        return f"<pre>{html.escape(repr(result))}</pre>"
    page = html.escape(result.report(), quote=True)
    return (
        f'<iframe srcdoc="{page}" title="{title}" '
        'style="width: 100%; height: 640px; border: 0"></iframe>'
    )
