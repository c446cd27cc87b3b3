# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Keywords of the library's options, derived from its C++ structs."""

import difflib
import inspect

from . import _core


def _parameter(name, default):
    kind = type(default).__name__
    return inspect.Parameter(
        name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=kind
    )


def _parameters(lists):
    """Parameter and meaning by name, in order; of a name in two lists the first counts."""
    parameters = {}
    for key in lists:
        for name, default, meaning in _core.options[key]:
            parameters.setdefault(name, (_parameter(name, default), meaning))
    return parameters


#: What lists are of, where a function has several.
_SUBJECTS = {
    "tracked": "the tracked method",
    "paper": "the paper's method",
    "truth": "errors against a ground truth",
    "distortion": "isometric distortion",
}


def _describe(lists):
    """Options in groups, a heading over each."""
    text = ""
    for key in lists:
        subject = f" of {_SUBJECTS[key]}" if len(lists) > 1 else ""
        text += f"\n\nOptions{subject} and their defaults:\n"
        for name, (parameter, meaning) in _parameters([key]).items():
            text += f"\n    {name} = {parameter.default!r}\n        {meaning}"
    return text


def takes_options(*lists):
    """Declares that a function's `**options` are those of the named lists of `_core.options`, in
    its signature and at the end of its description."""

    def decorate(function):
        parameters = _parameters(lists)
        signature = inspect.signature(function)
        own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        function.__signature__ = signature.replace(
            parameters=own + [parameter for parameter, _ in parameters.values()]
        )
        function.__doc__ = inspect.cleandoc(function.__doc__) + _describe(lists)
        return function

    return decorate


def check_options(options, *lists, function, methods=()):
    """Raises TypeError for a keyword that none of the lists has. It may be one of `methods`, lists
    that the function has at other times."""
    known = _parameters(lists)
    for name in options:
        if name in known:
            continue
        elsewhere = [_SUBJECTS[key] for key in methods if name in _parameters([key])]
        close = difflib.get_close_matches(name, known, 1)
        hint = f"did you mean {close[0]!r}? " if close else ""
        hint = f"it is one of {elsewhere[0]}; " if elsewhere else hint
        raise TypeError(
            f"{function} has no option {name!r}: {hint}its options are {', '.join(known)}"
        )


def select(options, key):
    """Those of `options` that belong to one list."""
    names = {name for name, _, _ in _core.options[key]}
    return {name: value for name, value in options.items() if name in names}
