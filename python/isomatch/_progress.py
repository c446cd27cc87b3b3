# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""How far long work is, for people who watch."""

import contextlib
import functools
import sys


class _Line:
    """One line on standard error that is written over."""

    def __init__(self):
        self.width = 0

    def __call__(self, fraction, stage):
        text = f"{100 * fraction:3.0f} % {stage}"
        sys.stderr.write("\r" + text.ljust(self.width))
        sys.stderr.flush()
        self.width = len(text)

    def close(self):
        if self.width > 0:
            sys.stderr.write("\n")


class _Bar:
    """A bar of tqdm, in notebooks that of a notebook."""

    def __init__(self, tqdm):
        self.bar = tqdm(total=100, bar_format="{l_bar}{bar}| {elapsed}")

    def __call__(self, fraction, stage):
        self.bar.set_description(stage)
        self.bar.update(100 * fraction - self.bar.n)

    def close(self):
        self.bar.close()


def _watcher():
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _Line()
    return _Bar(tqdm)


@contextlib.contextmanager
def shown(progress):
    """What the core calls for `progress`: nothing, a function, or for True a bar or line."""
    if progress is True:
        with contextlib.closing(_watcher()) as watcher:
            yield watcher
            watcher(1, "done")
    elif progress is None or progress is False:
        yield None
    elif callable(progress):
        yield progress
    else:
        raise TypeError(f"progress: expected True or a function, not {progress!r}")


def shows_progress(function):
    """Lets a function with the keyword `progress` take True as well."""

    @functools.wraps(function)
    def watched(*arguments, progress=None, **keywords):
        with shown(progress) as report:
            return function(*arguments, progress=report, **keywords)

    return watched
